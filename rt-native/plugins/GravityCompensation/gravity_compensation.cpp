#include "gravity_compensation.h"

#include "chosen_joints.h"

namespace robotui::rt::plugins {

bool GravityCompensation::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  params.knowsOnly({"joints", "chains", "damping"});
  damping_ = params.realOr("damping", damping_, 0, 1e4);
  robot_ = &setup.robot();
  joints_ = chosenJoints(params, setup.robot());
  gravity_.emplace(setup);
  setup.claim(namesOf(joints_));
  return true;
}

RtStatus GravityCompensation::on_start(double /*time*/) noexcept {
  status_ = "floating";
  return RtStatus::ok();
}

RtStatus GravityCompensation::control_loop(double /*time*/, double /*period*/) noexcept {
  const Eigen::VectorXd& weight = gravity_->update(*robot_);
  for (Joint* joint : joints_) joint->setEffortReference(weight[joint->index()] - damping_ * joint->getJointVelocity());
  return RtStatus::ok();
}

void GravityCompensation::on_stop(double /*time*/) noexcept { status_ = "stopped"; }

}  // namespace robotui::rt::plugins
