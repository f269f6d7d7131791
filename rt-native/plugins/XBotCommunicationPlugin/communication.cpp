#include "communication.h"

#include <algorithm>
#include <cmath>

#include "chosen_joints.h"
#include "held_position.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::plugins {
namespace {

bool isNumber(const link::JointCommand& command) noexcept {
  return std::isfinite(command.position) && std::isfinite(command.velocity) && std::isfinite(command.effort) &&
         std::isfinite(command.stiffness) && std::isfinite(command.damping);
}

// References farther apart are no stream: then a step is not spread over the whole silence.
constexpr double kLongestStep = 0.1;

bool hasPosition(const link::JointCommand& command) noexcept { return (command.mode & link::kPosition) != 0; }

// Every mode but the position alone or beside others, as XBot knows them.
void apply(Joint& joint, const link::JointCommand& command) noexcept {
  if ((command.mode & link::kVelocity) != 0) joint.setVelocityReference(command.velocity);
  if ((command.mode & link::kEffort) != 0) joint.setEffortReference(command.effort);
  if ((command.mode & link::kStiffness) != 0) joint.setStiffness(command.stiffness);
  if ((command.mode & link::kDamping) != 0) joint.setDamping(command.damping);
}

}  // namespace

bool XBotCommunicationPlugin::init_control_plugin(Setup& setup) {
  const auto joints = chosenJoints(config::Reader(setup.params(), {}, setup.name()), setup.robot());
  for (Joint* joint : joints) {
    joints_.push_back({joint, 0, 0, 0});
  }
  setup.claim(namesOf(joints));
  reader_ =
      std::make_unique<link::MasterReader>(setup.master(), static_cast<std::uint32_t>(setup.robot().getJointNum()));
  return true;
}

// What the master said before it was given the robot does not count.
RtStatus XBotCommunicationPlugin::on_start(double time) noexcept {
  readMaster(time);
  master_ = {};
  for (Held& held : joints_) {
    held.position = held.target = heldPosition(*held.joint);
  }
  status_ = "waiting for references";
  return RtStatus::ok();
}

bool XBotCommunicationPlugin::readMaster(double time) noexcept {
  const bool is_new = reader_->read(read_) == link::Read::kNew;
  if (is_new) master_ = read_;
  const bool valid = master_.valid_until_ns > link::now();
  if (is_new && valid) {
    aim(std::min(time - heard_, kLongestStep));
    heard_ = time;
  }
  return valid;
}

// The next reference is expected as long after this one as this one came after the last.
void XBotCommunicationPlugin::aim(double seconds) noexcept {
  for (Held& held : joints_) {
    const link::JointCommand& command = master_.joints[static_cast<std::size_t>(held.joint->index())];
    if (!hasPosition(command) || !isNumber(command)) continue;
    const double wanted = std::abs(command.position - held.position) / std::max(seconds, 1e-6);
    held.speed = std::min(wanted, held.joint->description().velocity);
    held.target = command.position;
  }
}

// What lies beyond the joint's limits is asked for, so that it is cut and counted, but not run after: the way back
// would be as long.
void XBotCommunicationPlugin::approach(Held& held, double period) noexcept {
  const config::JointDescription& limits = held.joint->description();
  const double step = held.speed * period;
  const double wanted = held.position + std::clamp(held.target - held.position, -step, step);
  held.joint->setPositionReference(wanted);
  held.position = std::clamp(wanted, limits.lower, limits.upper);
}

RtStatus XBotCommunicationPlugin::control_loop(double time, double period) noexcept {
  const bool valid = readMaster(time);
  status_ = valid ? "following the master" : "waiting for references";
  for (Held& held : joints_) {
    const link::JointCommand& command = master_.joints[static_cast<std::size_t>(held.joint->index())];
    const bool commanded = valid && command.mode != 0 && isNumber(command);
    if (commanded) apply(*held.joint, command);
    if (commanded && !hasPosition(command)) {
      held.position = held.target = held.joint->getJointPosition();
    } else {
      approach(held, period);
    }
  }
  return RtStatus::ok();
}

}  // namespace robotui::rt::plugins

using robotui::rt::plugins::XBotCommunicationPlugin;
ROBOTUI_RT_PLUGIN(XBotCommunicationPlugin)
