#include "moved_joints.h"

#include <algorithm>
#include <cmath>

#include "held_position.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kUnlimited = 1e6;  // rad/s or m/s
constexpr double kBraking = 0.8;    // of the deceleration: the last cycle before a limit takes a little more

// The velocity from which a joint still comes to rest within `way`, cycle by cycle, with that deceleration.
double stopping(double way, double deceleration, double period) noexcept {
  const double rest = std::max(way, 0.0);
  if (!std::isfinite(rest)) return kUnlimited;
  if (!std::isfinite(deceleration)) return rest / period;
  const double braking = kBraking * deceleration;
  const double half = braking * period / 2;
  return std::min(std::sqrt(half * half + 2 * braking * rest) - half, rest / period);
}

}  // namespace

MovedJoints::MovedJoints(const std::vector<Joint*>& joints, RobotInterface& robot, ModelInterface& model)
    : positions_(Eigen::VectorXd::Zero(model.getJointNum())) {
  const auto place = [&model](const Joint& joint) { return model.findJoint(joint.name())->index(); };
  for (Joint* joint : joints) joints_.push_back({joint, place(*joint), 0, 0});
  for (int i = 0; i < robot.getJointNum(); ++i) {
    const Joint& joint = robot.joint(i);
    if (std::find(joints.begin(), joints.end(), &joint) == joints.end()) others_.emplace_back(&joint, place(joint));
  }
}

std::vector<int> MovedJoints::places() const {
  std::vector<int> places;
  for (const Moved& moved : joints_) places.push_back(moved.in_model);
  return places;
}

void MovedJoints::start(ModelInterface& model) noexcept {
  for (Moved& moved : joints_) {
    const auto& limits = moved.joint->description();
    moved.position = std::clamp(heldPosition(*moved.joint), limits.lower, limits.upper);
    moved.velocity = 0;
  }
  update(model);
}

void MovedJoints::bound(VelocityBounds& bounds, double period) const noexcept {
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Moved& moved = joints_[static_cast<std::size_t>(i)];
    const auto& limits = moved.joint->description();
    const double most = limits.velocity > 0 ? limits.velocity : kUnlimited;
    const double change = limits.acceleration * period;
    bounds.reach_upper[i] = stopping(limits.upper - moved.position, limits.acceleration, period);
    bounds.reach_lower[i] = -stopping(moved.position - limits.lower, limits.acceleration, period);
    bounds.upper[i] = std::min({bounds.reach_upper[i], most, moved.velocity + change});
    bounds.lower[i] = std::max({bounds.reach_lower[i], -most, moved.velocity - change});
    if (bounds.lower[i] > bounds.upper[i]) bounds.lower[i] = bounds.upper[i] = (bounds.lower[i] + bounds.upper[i]) / 2;
    bounds.reach_upper[i] = std::max(bounds.reach_upper[i], bounds.upper[i]);
    bounds.reach_lower[i] = std::min(bounds.reach_lower[i], bounds.lower[i]);
  }
}

bool MovedJoints::isAtLimit(Eigen::Index i, double velocity, const VelocityBounds& bounds) const noexcept {
  constexpr double kNear = 1e-6;
  const auto& limits = joint(i).description();
  const double most = limits.velocity > 0 ? limits.velocity : kUnlimited;
  return (velocity > bounds.reach_upper[i] - kNear && bounds.reach_upper[i] < most) ||
         (velocity < bounds.reach_lower[i] + kNear && bounds.reach_lower[i] > -most);
}

void MovedJoints::move(const Eigen::VectorXd& velocities, double period, ModelInterface& model) noexcept {
  for (Eigen::Index i = 0; i < size(); ++i) {
    Moved& moved = joints_[static_cast<std::size_t>(i)];
    const auto& limits = moved.joint->description();
    moved.velocity = velocities[i];
    moved.position = std::clamp(moved.position + moved.velocity * period, limits.lower, limits.upper);
    moved.joint->setPositionReference(moved.position);
  }
  update(model);
}

void MovedJoints::update(ModelInterface& model) noexcept {
  for (const auto& [joint, place] : others_) positions_[place] = heldPosition(*joint);
  for (const Moved& moved : joints_) positions_[moved.in_model] = moved.position;
  model.setJointPosition(positions_);
  model.update();
}

}  // namespace robotui::rt::plugins
