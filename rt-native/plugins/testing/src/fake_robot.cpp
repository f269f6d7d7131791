#include "robotui/rt/testing/fake_robot.h"

#include <stdexcept>

namespace robotui::rt::testing {

std::shared_ptr<const config::RobotDescription> fakeDescription(int joints) {
  config::RobotDescription robot{};
  robot.name = "fake";
  config::ChainDescription arm{"arm", "base", "tip", {}};
  config::Posture home{"home", "arm", {}};
  config::Posture zero{"zero", "arm", {}};
  for (int i = 1; i <= joints; ++i) {
    const std::string name = "j" + std::to_string(i);
    config::JointDescription joint{};
    joint.id = i;
    joint.name = name;
    joint.type = config::JointType::kRevolute;
    joint.lower = -2;
    joint.upper = 2;
    joint.velocity = 1;
    joint.effort = 10;
    robot.joints.push_back(joint);
    arm.joints.push_back(name);
    home.joints.emplace_back(name, 0.5);
    zero.joints.emplace_back(name, 0.0);
  }
  robot.chains.push_back(arm);
  robot.postures = {home, zero};
  return std::make_shared<const config::RobotDescription>(std::move(robot));
}

FakeRobot::FakeRobot(std::shared_ptr<const config::RobotDescription> description)
    : RobotInterface(std::move(description)) {}

bool FakeRobot::move() noexcept {
  commanded_ = 0;
  for (std::size_t i = 0; i < states().size(); ++i) {
    link::JointCommand& command = commands()[i];
    link::JointState& state = states()[i];
    if (command.mode == 0) {
      continue;
    }
    ++commanded_;
    state.mode = command.mode;
    const double before = state.link_position;
    if ((command.mode & link::kPosition) != 0) {
      state.position_reference = state.link_position = command.position;
    } else if ((command.mode & link::kVelocity) != 0) {
      state.velocity_reference = command.velocity;
      state.link_position += command.velocity * period_;
    }
    if ((command.mode & link::kEffort) != 0) {
      state.effort_reference = state.effort = command.effort;
    }
    state.stiffness = (command.mode & link::kStiffness) != 0 ? command.stiffness : state.stiffness;
    state.damping = (command.mode & link::kDamping) != 0 ? command.damping : state.damping;
    state.motor_position = state.link_position;
    state.link_velocity = state.motor_velocity = (state.link_position - before) / period_;
    command.mode = 0;
  }
  return true;
}

void FakeRobot::put(const std::string& joint, double position) {
  const Joint* found = findJoint(joint);
  if (found == nullptr) {
    throw std::runtime_error("The fake robot has no joint " + joint + ".");
  }
  link::JointState& state = states()[static_cast<std::size_t>(found->index())];
  state.link_position = state.motor_position = state.position_reference = position;
}

}  // namespace robotui::rt::testing
