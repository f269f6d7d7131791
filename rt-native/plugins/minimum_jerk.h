// The smoothest way from one place to another: no jump of velocity or acceleration at its ends.
#pragma once

#include <algorithm>

namespace robotui::rt::plugins {

// `done` from 0 to 1; beyond, its ends.
inline double minimumJerk(double from, double to, double done) noexcept {
  const double s = std::clamp(done, 0.0, 1.0);
  return from + (to - from) * s * s * s * (10 + s * (6 * s - 15));
}

}  // namespace robotui::rt::plugins
