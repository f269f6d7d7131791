// Whether a frame still comes nearer to its target.
#pragma once

#include <algorithm>
#include <limits>

#include "straight_path.h"

namespace robotui::rt::plugins {

class TargetProgress {
 public:
  // There is another target.
  void begin() noexcept { *this = {}; }
  // A cycle: the rest of the way, and how fast the frame would go there if nothing were in its way.
  void look(const Twist& rest, const SpeedLimits& speeds, double period) noexcept {
    const double now = rest.head<3>().norm() + kArm * rest.tail<3>().norm();
    seconds_ += period;
    if (now > least_ - kLeastPart * std::min(speeds.linear, kArm * speeds.angular)) return;
    least_ = now;
    seconds_ = 0;
  }
  bool isStuck() const noexcept { return seconds_ > kPatience; }

 private:
  static constexpr double kPatience = 1;      // s
  static constexpr double kArm = 0.2;         // m that a radian counts as
  static constexpr double kLeastPart = 1e-3;  // s of its speed

  double least_ = std::numeric_limits<double>::max();
  double seconds_ = 0;  // since it was nearer than ever
};

}  // namespace robotui::rt::plugins
