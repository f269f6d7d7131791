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

void GravityCompensation::on_start(double /*time*/) { status_ = "floating"; }

void GravityCompensation::control_loop(double /*time*/, double /*period*/) {
  const Eigen::VectorXd& weight = gravity_->update(*robot_);
  for (Joint* joint : joints_) joint->setEffortReference(weight[joint->index()] - damping_ * joint->getJointVelocity());
}

void GravityCompensation::on_stop(double /*time*/) { status_ = "stopped"; }

}  // namespace robotui::rt::plugins
