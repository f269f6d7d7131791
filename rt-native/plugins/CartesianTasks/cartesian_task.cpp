#include "cartesian_task.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace robotui::rt::plugins {
namespace {

constexpr double kGain = 10;     // 1/s, with which an error of the frame decays
constexpr double kThere = 1e-3;  // m and rad

LinkId findLink(const ModelInterface& model, const std::string& name) {
  const LinkId link = model.findLink(name);
  if (!link.isValid()) throw std::runtime_error("the robot has no link '" + name + "'");
  return link;
}

Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double most) noexcept {
  const double length = vector.norm();
  return length > most ? Eigen::Vector3d(vector * (most / length)) : vector;
}

}  // namespace

CartesianTask::CartesianTask(TaskDescription description, const ModelInterface& model, std::vector<int> joints)
    : description_(std::move(description)), link_(findLink(model, description_.link)),
      base_(findLink(model, description_.base)), joints_(std::move(joints)),
      rows_(std::count(description_.mask.begin(), description_.mask.end(), true)), is_active_(description_.active),
      jacobian_(6, model.getDofs()), base_jacobian_(6, model.getDofs()),
      relative_(6, static_cast<Eigen::Index>(joints_.size())) {}

void CartesianTask::setActive(bool active) noexcept {
  if (active && !is_active_) rest();
  is_active_ = active;
}

void CartesianTask::update(const ModelInterface& model) noexcept {
  Eigen::Isometry3d base;
  Eigen::Isometry3d link;
  model.getPose(base_, base);
  model.getPose(link_, link);
  model.getJacobian(link_, jacobian_);
  model.getJacobian(base_, base_jacobian_);
  at_ = base.inverse(Eigen::Isometry) * link;
  const Eigen::Matrix3d to_base = base.linear().transpose();
  const Eigen::Vector3d arm = link.translation() - base.translation();
  const Eigen::Index offset = jacobian_.cols() - model.getJointNum();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Twist of_link = jacobian_.col(offset + joints_[i]);
    const Twist of_base = base_jacobian_.col(offset + joints_[i]);
    const Eigen::Vector3d linear = of_link.head<3>() - of_base.head<3>() + arm.cross(of_base.tail<3>());
    const Eigen::Vector3d angular = of_link.tail<3>() - of_base.tail<3>();
    relative_.col(static_cast<Eigen::Index>(i)) << to_base * linear, to_base * angular;
  }
}

void CartesianTask::beginPath() noexcept {
  seconds_left_ = 0;
  progress_.begin();
}

void CartesianTask::rest() noexcept {
  beginPath();
  path_.rest(at_);
}

void CartesianTask::stop() noexcept {
  beginPath();
  path_.stop(at_, description_.speeds);
}

void CartesianTask::setVelocity(const Twist& velocity) noexcept {
  velocity_ << shortened(velocity.head<3>(), description_.speeds.linear),
      shortened(velocity.tail<3>(), description_.speeds.angular);
  velocity_ = masked(velocity_);
  if (seconds_left_ <= 0) path_.stop(at_, description_.speeds);
  seconds_left_ = description_.timeout;
  progress_.begin();
}

Twist CartesianTask::masked(Twist twist) const noexcept {
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (!description_.mask[static_cast<std::size_t>(i)]) twist[i] = 0;
  }
  return twist;
}

void CartesianTask::put(double period, Eigen::Ref<Eigen::MatrixXd> rows, Eigen::Ref<Eigen::VectorXd> wanted) noexcept {
  const Twist behind = masked(poseDifference(at_, path_.now()));
  const bool is_led = isLedByVelocity();
  const Twist along = is_led ? path_.follow(behind, velocity_, description_.speeds, period)
                             : path_.advance(behind, description_.speeds, period);
  if (is_led)
    seconds_left_ -= period;
  else
    progress_.look(toTarget(), description_.speeds, period);
  const Twist twist = along + kGain * masked(poseDifference(at_, path_.now()));
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (!description_.mask[static_cast<std::size_t>(i)]) continue;
    rows.row(row) = relative_.row(i);
    wanted[row++] = twist[i];
  }
}

bool CartesianTask::isThere() const noexcept { return toTarget().cwiseAbs().maxCoeff() < kThere; }

}  // namespace robotui::rt::plugins
