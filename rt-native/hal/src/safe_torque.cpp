#include "safe_torque.h"

#include <algorithm>

namespace robotui::rt::hal {

void NoTorque::compute(const Measurements& /*measured*/, std::span<double> effort) noexcept {
  std::fill(effort.begin(), effort.end(), 0.0);
}

}  // namespace robotui::rt::hal
