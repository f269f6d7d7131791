#include "gravity_model.h"

namespace robotui::rt::plugins {

GravityModel::GravityModel(Setup& setup)
    : model_(setup.createModel()), base_(*model_), efforts_(Eigen::VectorXd::Zero(model_->getDofs())),
      joints_(Eigen::VectorXd::Zero(model_->getJointNum())) {
  model_->pair(setup.robot());
}

const Eigen::VectorXd& GravityModel::update(const RobotInterface& robot) noexcept {
  if (base_.index() >= 0) base_.turn(*model_, robot.imus()[static_cast<std::size_t>(base_.index())].orientation());
  model_->syncFrom(robot);
  model_->computeGravityCompensation(efforts_);
  joints_ = efforts_.tail(joints_.size());
  return joints_;
}

}  // namespace robotui::rt::plugins
