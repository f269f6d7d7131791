// What a joint is told where its hardware takes one number at a time: a position, a velocity or an effort.
#pragma once

#include <cstdint>

#include "robotui/rt/hal/hal.h"
namespace robotui::rt::hal {

struct JointSample {
  double position;
  double velocity;
  double effort;
};

enum class Way : std::uint8_t { kNone = 0, kPosition = 1, kVelocity = 2, kEffort = 3 };

struct Command {
  Way way;
  double value;
};

// Controllers of simulators and drives take one number and have gains of their own. A reference with a stiffness or a
// damping becomes an effort, computed here from what was measured, where the joint takes one; `most_effort` bounds it.
Command commandOf(const Reference& reference, const JointSample& measured, bool takes_effort,
                  double most_effort) noexcept;

}  // namespace robotui::rt::hal
