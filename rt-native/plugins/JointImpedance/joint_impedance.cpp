#include "joint_impedance.h"

#include <algorithm>
#include <cmath>

#include "chosen_joints.h"
#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kMostStiffness = 1e5;
constexpr double kMostDamping = 1e4;

bool setFrom(std::string_view words, std::string_view verb, double most, double& value) noexcept {
  if (!words.starts_with(verb)) return false;
  double read = 0;
  if (readNumbers(words.substr(verb.size()), &read, 1) != 1 || read < 0 || read > most) return false;
  value = read;
  return true;
}

}  // namespace

bool JointImpedance::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  params.knowsOnly({"joints", "chains", "stiffness", "damping", "ramp", "gravity"});
  stiffness_goal_ = params.realOr("stiffness", stiffness_goal_, 0, kMostStiffness);
  damping_goal_ = params.realOr("damping", damping_goal_, 0, kMostDamping);
  ramp_ = params.realOr("ramp", ramp_, 0, 60);
  robot_ = &setup.robot();
  const auto joints = chosenJoints(params, setup.robot());
  for (Joint* joint : joints) springs_.push_back({joint, 0});
  if (params.flagOr("gravity", false)) gravity_.emplace(setup);
  setup.claim(namesOf(joints));
  return true;
}

// Damping comes at once, stiffness slowly: the robot settles instead of jumping.
RtStatus JointImpedance::on_start(double /*time*/) noexcept {
  for (Spring& spring : springs_) spring.rest = spring.joint->getJointPosition();
  stiffness_ = ramp_ > 0 ? 0 : stiffness_goal_;
  damping_ = damping_goal_;
  return RtStatus::ok();
}

double JointImpedance::approach(double value, double goal, double most, double period) const noexcept {
  const double step = ramp_ > 0 ? most * period / ramp_ : most;
  return std::clamp(goal, value - step, value + step);
}

RtStatus JointImpedance::control_loop(double /*time*/, double period) noexcept {
  stiffness_ = approach(stiffness_, stiffness_goal_, std::max(stiffness_goal_, stiffness_), period);
  damping_ = approach(damping_, damping_goal_, std::max(damping_goal_, damping_), period);
  const Eigen::VectorXd* weight = gravity_ ? &gravity_->update(*robot_) : nullptr;
  for (const Spring& spring : springs_) {
    spring.joint->setPositionReference(spring.rest);
    spring.joint->setStiffness(stiffness_);
    spring.joint->setDamping(damping_);
    if (weight != nullptr) spring.joint->setEffortReference((*weight)[spring.joint->index()]);
  }
  status_ = stiffness_ == stiffness_goal_ ? "holding" : "changing its stiffness";
  return RtStatus::ok();
}

void JointImpedance::on_stop(double /*time*/) noexcept { status_ = "stopped"; }

bool JointImpedance::on_command(std::string_view words) {
  return setFrom(words, "stiffness ", kMostStiffness, stiffness_goal_) ||
         setFrom(words, "damping ", kMostDamping, damping_goal_);
}

}  // namespace robotui::rt::plugins
