#include "joint_limits.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::hal {

namespace {

// A velocity reference reaches the joint's limit from rest in this time, not sooner: URDF has no limit of acceleration.
constexpr double kTimeToFullVelocity = 0.1;

constexpr std::uint8_t kKnownModes = link::kPosition | link::kVelocity | link::kEffort | link::kImpedance;

bool has(std::uint8_t mode, link::Mode bit) noexcept { return (mode & bit) != 0; }

bool isGain(double value) noexcept { return std::isfinite(value) && value >= 0; }

bool cut(double& value, double lower, double upper) noexcept {
  const double within = std::min(std::max(value, lower), upper);
  const bool different = within != value;
  value = within;
  return different;
}

}  // namespace

link::Objection objectionTo(const link::JointCommand& command) noexcept {
  const std::uint8_t mode = command.mode;
  if ((mode & ~kKnownModes) != 0) return link::Objection::kUnknownMode;
  const bool are_numbers = (!has(mode, link::kPosition) || std::isfinite(command.position)) &&
                           (!has(mode, link::kVelocity) || std::isfinite(command.velocity)) &&
                           (!has(mode, link::kEffort) || std::isfinite(command.effort));
  if (!are_numbers) return link::Objection::kNoNumber;
  const bool are_gains = (!has(mode, link::kStiffness) || isGain(command.stiffness)) &&
                         (!has(mode, link::kDamping) || isGain(command.damping));
  return are_gains ? link::Objection::kNone : link::Objection::kBadGain;
}

Limits::Limits(const config::JointDescription& joint, double period_s) noexcept
    : lower_(joint.lower), upper_(joint.upper), velocity_(joint.velocity), effort_(joint.effort),
      position_step_(joint.velocity * period_s), velocity_step_(joint.velocity * period_s / kTimeToFullVelocity) {}

bool Limits::applyAtOnce(Reference& wanted) const noexcept {
  bool different = false;
  if (has(wanted.mode, link::kPosition)) different |= cut(wanted.position, lower_, upper_);
  if (has(wanted.mode, link::kVelocity)) different |= cut(wanted.velocity, -velocity_, velocity_);
  if (has(wanted.mode, link::kEffort)) different |= cut(wanted.effort, -effort_, effort_);
  return different;
}

// The step comes last: a joint that stands outside its limits goes in slowly. Infinite limits cut nothing.
bool Limits::applyStep(Reference& wanted, const Reference& last) const noexcept {
  bool different = false;
  if (has(wanted.mode, link::kPosition))
    different |= cut(wanted.position, last.position - position_step_, last.position + position_step_);
  const bool leads = !has(wanted.mode, link::kPosition);  // else it is the derivative that comes with a position
  if (has(wanted.mode, link::kVelocity) && leads)
    different |= cut(wanted.velocity, last.velocity - velocity_step_, last.velocity + velocity_step_);
  return different;
}

}  // namespace robotui::rt::hal
