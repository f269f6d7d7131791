// What one joint is told on which of its topics.
#pragma once

#include <cstdint>

#include "robotui/rt/hal/hal.h"
#include "sample.h"

namespace robotui::rt::hal::gazebo {

enum class Way : std::uint8_t { kNone = 0, kPosition = 1, kVelocity = 2, kEffort = 3 };

struct Command {
  Way way;
  double value;
};

// A controller of the simulator takes one number and has gains of its own. A reference with a stiffness or a damping
// becomes an effort, computed here from what was measured, where the simulated joint takes one; `most_effort` bounds
// it.
Command commandOf(const Reference& reference, const JointSample& measured, bool takes_effort,
                  double most_effort) noexcept;

}  // namespace robotui::rt::hal::gazebo
