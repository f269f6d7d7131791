// Emergency stops of a robot that is simulated: a user presses and releases them.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "robotui/rt/hal/hal.h"
#include "robotui/rt/link/stop_bits.h"

namespace robotui::rt::hal {

class SimulatedStops {
 public:
  void sense(std::span<StopInput> into) const noexcept {
    const std::uint32_t pressed = pressed_.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i < into.size(); ++i)
      into[i] = (pressed >> i & 1U) != 0 ? StopInput::kPressed : StopInput::kReleased;
  }

  // From any thread.
  bool press(std::size_t stop, bool pressed) noexcept {
    if (stop >= link::kMaxStops) return false;
    if (pressed)
      pressed_.fetch_or(1U << stop, std::memory_order_relaxed);
    else
      pressed_.fetch_and(~(1U << stop), std::memory_order_relaxed);
    return true;
  }

 private:
  std::atomic<std::uint32_t> pressed_{0};
};

}  // namespace robotui::rt::hal
