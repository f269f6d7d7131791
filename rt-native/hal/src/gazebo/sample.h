// What the simulator said of all joints at one moment of simulated time, by index of the robot.
#pragma once

#include <array>
#include <cstdint>

#include "../one_way.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::hal::gazebo {

struct Sample {
  std::int64_t stamp_ns;  // simulated time
  std::int64_t heard_ns;  // CLOCK_MONOTONIC
  std::uint64_t era;      // rises whenever simulated time went back, and the robot may be anywhere
  std::array<JointSample, link::kMaxJoints> joints;
};

}  // namespace robotui::rt::hal::gazebo
