// What a joint may be told, whatever asks for it.
#pragma once

#include "robotui/rt/config/config.h"
#include "robotui/rt/hal/hal.h"
#include "robotui/rt/link/joint_event.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::hal {

// What speaks against a command: something in it is unknown, or what it means is no number. Then it is rejected whole.
link::Objection objectionTo(const link::JointCommand& command) noexcept;

// Of one joint. Keeps no state: `last` is what went to the hardware before.
class Limits {
 public:
  Limits(const config::JointDescription& joint, double period_s) noexcept;

  // Cuts what is wanted, in place; true where something was cut: what is beyond the joint's range, and then what is too
  // far from the last reference for one cycle.
  bool applyAtOnce(Reference& wanted) const noexcept;
  bool applyStep(Reference& wanted, const Reference& last) const noexcept;

  double effort() const noexcept { return effort_; }

 private:
  double lower_;
  double upper_;
  double velocity_;
  double effort_;
  double position_step_;  // in one period
  double velocity_step_;
};

}  // namespace robotui::rt::hal
