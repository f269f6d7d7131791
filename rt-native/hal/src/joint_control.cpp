#include "joint_control.h"

#include <cmath>
#include <utility>

namespace robotui::rt::hal {

namespace {

constexpr std::uint8_t kLeading = link::kPosition | link::kVelocity | link::kEffort;

}  // namespace

void JointControl::anchor(const link::JointState& measured) noexcept {
  reference_.position = measured.link_position;
  limiter_.reset(reference_.position);
}

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
  send(wanted, is_new);
  control_ = link::Control::kCommanded;
  return Outcome::kObeyed;
}

double JointControl::followingError(const link::JointState& measured) const noexcept {
  const bool is_led = (reference_.mode & link::kPosition) != 0 && (reference_.mode & link::kImpedance) == 0;
  return is_led ? std::abs(reference_.position - measured.link_position) : 0;
}

// References of modes that do not count are zero, so that a later command starts from there.
void JointControl::send(Reference wanted, bool is_new) noexcept {
  const bool is_led = limiter_.isActive() && (wanted.mode & (link::kPosition | link::kVelocity)) != 0;
  const bool is_due = isDue(is_new);
  if (is_led ? lead(wanted, is_new, is_due) : limit(wanted, is_due)) ++clamped_;
  if (limiter_.isActive() && !is_led) limiter_.reset(reference_.position);
  if ((wanted.mode & link::kVelocity) == 0) wanted.velocity = 0;
  if ((wanted.mode & link::kEffort) == 0) wanted.effort = 0;
  reference_ = wanted;
}

// The reference of a thread that is slower than the HAL has until its next answer to come to what was wanted: one that
// only lags behind until then was not cut.
bool JointControl::isDue(bool is_new) noexcept {
  if (is_new) answers_every_ = std::exchange(since_answer_, 0);
  return ++since_answer_ >= answers_every_;
}

bool JointControl::limit(Reference& wanted, bool is_due) noexcept {
  const bool is_beyond = limits_.applyAtOnce(wanted);
  const bool lags = limits_.applyStep(wanted, reference_);
  return is_beyond || (lags && is_due);
}

// By position, or by velocity where there is none; the velocity that comes with a position is that of what it is led
// by.
bool JointControl::lead(Reference& wanted, bool is_new, bool is_due) noexcept {
  bool different = limits_.applyAtOnce(wanted);
  const bool was_by_velocity = (reference_.mode & link::kPosition) == 0;
  if ((wanted.mode & link::kPosition) != 0 && was_by_velocity) limiter_.reset(reference_.position);
  if ((wanted.mode & link::kPosition) != 0) {
    const double before = wanted.position;
    wanted.position = limiter_.follow(wanted.position, is_new);
    different |= limiter_.isBehind();
    if (wanted.position != before && (wanted.mode & link::kVelocity) != 0) wanted.velocity = limiter_.velocity();
  } else {
    wanted.velocity = limiter_.followVelocity(wanted.velocity);
    different |= is_due && limiter_.isBehind();
  }
  return different;
}

// Comes to rest within its limits, rather than at once.
void JointControl::brake(Reference& wanted) noexcept {
  if ((wanted.mode & link::kPosition) != 0)
    wanted.position = limiter_.brake();
  else if ((wanted.mode & link::kVelocity) != 0)
    wanted.velocity = limiter_.followVelocity(0);
  if ((wanted.mode & (link::kPosition | link::kVelocity)) == (link::kPosition | link::kVelocity))
    wanted.velocity = limiter_.velocity();
}

// Not counted as clamped: nobody asked for more.
void JointControl::hold(link::Control why, double safe_effort) noexcept {
  Reference wanted = reference_;
  wanted.velocity = 0;
  wanted.effort = safe_effort;
  const double position = wanted.position;
  limits_.applyAtOnce(wanted);
  limits_.applyStep(wanted, reference_);
  wanted.position = position;  // also where it stands outside its limits
  if (limiter_.isActive()) brake(wanted);
  if ((wanted.mode & link::kEffort) == 0) wanted.effort = 0;
  reference_ = wanted;
  control_ = why;
}

bool JointControl::isAtRest() const noexcept {
  return reference_.velocity == 0 && (!limiter_.isActive() || limiter_.isAtRest());
}

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
