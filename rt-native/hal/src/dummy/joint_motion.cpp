#include "joint_motion.h"

#include <algorithm>

namespace robotui::rt::hal {

namespace {

constexpr double kInertia = 0.5;   // kg m^2, of a medium arm joint
constexpr double kFriction = 2.0;  // N m s/rad
constexpr float kTemperature = 25;

}  // namespace

JointMotion::JointMotion(const config::JointDescription& joint, double position) noexcept
    : lower_(joint.lower), upper_(joint.upper), fastest_(joint.velocity),
      position_(std::clamp(position, joint.lower, joint.upper)) {}

double JointMotion::wantedVelocity(const Reference& reference, double seconds) const noexcept {
  if ((reference.mode & link::kPosition) != 0) return (reference.position - position_) / seconds;
  if ((reference.mode & link::kVelocity) != 0) return reference.velocity;
  // Implicit in the friction, so that no step is too long for it.
  if ((reference.mode & link::kEffort) != 0)
    return (velocity_ + reference.effort / kInertia * seconds) / (1 + kFriction / kInertia * seconds);
  return 0;
}

void JointMotion::step(const Reference& reference, double seconds) noexcept {
  if (!(seconds > 0)) return;
  velocity_ = std::clamp(wantedVelocity(reference, seconds), -fastest_, fastest_);
  const double reached = std::clamp(position_ + velocity_ * seconds, lower_, upper_);
  if (reached == lower_ || reached == upper_) velocity_ = (reached - position_) / seconds;
  position_ = reached;
  effort_ = (reference.mode & link::kEffort) != 0 ? reference.effort : 0;
}

void JointMotion::measure(link::JointState& into) const noexcept {
  into.link_position = into.motor_position = position_;
  into.link_velocity = into.motor_velocity = velocity_;
  into.effort = effort_;
  into.temperature_motor = into.temperature_driver = kTemperature;
  into.fault = 0;
}

}  // namespace robotui::rt::hal
