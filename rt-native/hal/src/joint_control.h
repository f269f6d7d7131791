// Who moves a joint, and what goes to its hardware: owner, hold per mode, safe state, limits.
#pragma once

#include "joint_limits.h"
#include "reference_limiter.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::hal {

class JointControl {
 public:
  JointControl(const config::JointDescription& joint, double period_s) noexcept
      : limits_(joint, period_s), limiter_(joint, period_s) {}

  // The position reference is what is measured, from which all goes on: at the first sense, and after the hardware was
  // away.
  void anchor(const link::JointState& measured) noexcept;

  // Once a cycle, before anything below. True where it was granted anew: that ends its safe state.
  bool belongs(std::uint16_t owner, std::uint32_t grant, const link::JointState& measured) noexcept;

  // Safe from now on, until it is granted anew.
  void makeSafe() noexcept { safe_ = true; }

  bool isSafe() const noexcept { return safe_; }
  std::uint16_t owner() const noexcept { return owner_; }

  // What became of what its plugin wants in this cycle: the joint is to hold unless it was obeyed.
  enum class Outcome : std::uint8_t { kNothing, kObeyed, kRejected };

  // `is_new` is false for an answer that was looked at in a cycle before.
  Outcome command(const link::JointCommand& command, bool is_new) noexcept;

  // Of the last command that was rejected, and how many answers were so in turn.
  link::Objection objection() const noexcept { return objection_; }
  std::uint32_t rejectedInTurn() const noexcept { return rejected_in_turn_; }
  std::uint32_t rejected() const noexcept { return rejected_; }
  std::uint32_t grant() const noexcept { return grant_; }

  // How far it is from where it was told to be, rad or m; zero where its mode lets it give way.
  double followingError(const link::JointState& measured) const noexcept;

  // Whether hold() needs the effort of the safe law.
  bool holdsByEffort() const noexcept { return (reference_.mode & link::kEffort) != 0; }

  // Positions hold, velocities go to zero, efforts follow the safe law.
  void hold(link::Control why, double safe_effort) noexcept;

  const Reference& reference() const noexcept { return reference_; }
  bool isAtRest() const noexcept;

  // References, owner, counters.
  void describe(link::JointState& into) const noexcept;

 private:
  void send(Reference wanted, bool is_new) noexcept;
  bool isDue(bool is_new) noexcept;
  bool lead(Reference& wanted, bool is_new, bool is_due) noexcept;
  bool limit(Reference& wanted, bool is_due) noexcept;
  void brake(Reference& wanted) noexcept;

  Limits limits_;
  ReferenceLimiter limiter_;
  Reference reference_{0, 0, 0, 0, 0, link::kPosition};
  std::uint32_t grant_ = 0;
  std::uint32_t clamped_ = 0;
  std::uint32_t answers_every_ = 0;  // cycles from one answer of its plugin to the next
  std::uint32_t since_answer_ = 0;
  std::uint32_t rejected_ = 0;
  std::uint32_t rejected_in_turn_ = 0;
  link::Objection objection_ = link::Objection::kNone;
  std::uint16_t owner_ = link::kNobody;
  link::Control control_ = link::Control::kFree;
  bool safe_ = false;
  bool known_ = false;  // whether grant_ was ever read
};

}  // namespace robotui::rt::hal
