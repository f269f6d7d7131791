#include "joint_control.h"

#include <cmath>

namespace robotui::rt::hal {

namespace {

constexpr std::uint8_t kLeading = link::kPosition | link::kVelocity | link::kEffort;

}  // namespace

void JointControl::anchor(const link::JointState& measured) noexcept { reference_.position = measured.link_position; }

// What was owned before this HAL began was moved by somebody: it must not go on by itself.
bool JointControl::belongs(std::uint16_t owner, std::uint32_t grant, const link::JointState& measured) noexcept {
  const bool anew = known_ && grant != grant_;
  if (!known_ && owner != link::kNobody) safe_ = true;
  known_ = true;
  grant_ = grant;
  owner_ = owner;
  if (anew) {
    safe_ = false;
    rejected_in_turn_ = 0;
    anchor(measured);
  }
  return anew;
}

JointControl::Outcome JointControl::command(const link::JointCommand& command, bool is_new) noexcept {
  if (command.mode == 0) return Outcome::kNothing;
  const link::Objection objection = command.plugin != owner_ ? link::Objection::kNotOwner : objectionTo(command);
  if (objection != link::Objection::kNone) {
    objection_ = objection;
    ++rejected_;
    if (is_new) ++rejected_in_turn_;
    return Outcome::kRejected;
  }
  rejected_in_turn_ = 0;
  Reference wanted = reference_;
  const std::uint8_t leading = command.mode & kLeading;
  wanted.mode = static_cast<std::uint8_t>((leading != 0 ? leading : reference_.mode & kLeading) |
                                          ((command.mode | reference_.mode) & link::kImpedance));
  if ((command.mode & link::kPosition) != 0) wanted.position = command.position;
  if ((command.mode & link::kVelocity) != 0) wanted.velocity = command.velocity;
  if ((command.mode & link::kEffort) != 0) wanted.effort = command.effort;
  if ((command.mode & link::kStiffness) != 0) wanted.stiffness = command.stiffness;
  if ((command.mode & link::kDamping) != 0) wanted.damping = command.damping;
  send(wanted);
  control_ = link::Control::kCommanded;
  return Outcome::kObeyed;
}

double JointControl::followingError(const link::JointState& measured) const noexcept {
  const bool is_led = (reference_.mode & link::kPosition) != 0 && (reference_.mode & link::kImpedance) == 0;
  return is_led ? std::abs(reference_.position - measured.link_position) : 0;
}

// References of modes that do not count are zero, so that a later command starts from there.
void JointControl::send(Reference wanted) noexcept {
  if (limits_.apply(wanted, reference_)) ++clamped_;
  if ((wanted.mode & link::kVelocity) == 0) wanted.velocity = 0;
  if ((wanted.mode & link::kEffort) == 0) wanted.effort = 0;
  reference_ = wanted;
}

// Not counted as clamped: nobody asked for more.
void JointControl::hold(link::Control why, double safe_effort) noexcept {
  Reference wanted = reference_;
  wanted.velocity = 0;
  wanted.effort = safe_effort;
  const double position = wanted.position;
  limits_.apply(wanted, reference_);
  wanted.position = position;  // also where it stands outside its limits
  if ((wanted.mode & link::kEffort) == 0) wanted.effort = 0;
  reference_ = wanted;
  control_ = why;
}

bool JointControl::isAtRest() const noexcept { return reference_.velocity == 0; }

void JointControl::describe(link::JointState& into) const noexcept {
  into.position_reference = reference_.position;
  into.velocity_reference = reference_.velocity;
  into.effort_reference = reference_.effort;
  into.stiffness = reference_.stiffness;
  into.damping = reference_.damping;
  into.clamped = clamped_;
  into.rejected = rejected_;
  into.owner = owner_;
  into.mode = reference_.mode;
  into.control = static_cast<std::uint8_t>(control_);
}

}  // namespace robotui::rt::hal
