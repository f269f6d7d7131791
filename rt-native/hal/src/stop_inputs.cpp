#include "stop_inputs.h"

#include <algorithm>

namespace robotui::rt::hal {

namespace {

constexpr unsigned kHalf = 16;

std::uint32_t packed(const link::StopBits& bits) noexcept { return std::uint32_t{bits.pressed} << kHalf | bits.unread; }

}  // namespace

void StopInputs::look(Hal& hal, std::uint64_t cycle) noexcept {
  if (inputs_.empty()) return;
  was_stopped_ = isStopped();
  std::fill(inputs_.begin(), inputs_.end(), StopInput::kUnread);
  hal.senseStops(inputs_);
  bits_ = {};
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const auto bit = static_cast<std::uint16_t>(1U << i);
    if (inputs_[i] == StopInput::kPressed) bits_.pressed |= bit;
    if (inputs_[i] != StopInput::kPressed && inputs_[i] != StopInput::kReleased) bits_.unread |= bit;
  }
  known_ = static_cast<std::uint16_t>(known_ | ~bits_.unread);
  if (isStopped() && !was_stopped_) since_.store(cycle, std::memory_order_relaxed);
  tell(cycle);
}

void StopInputs::tell(std::uint64_t cycle) noexcept {
  link::StopBits told = bits_;
  if (cycle < unread_after_) told.unread &= known_;
  now_.store(packed(told), std::memory_order_release);
  if (told.any()) seen_.fetch_or(packed(told), std::memory_order_release);
}

StopReport StopInputs::take() noexcept {
  const std::uint32_t both = seen_.exchange(0, std::memory_order_acquire) | now_.load(std::memory_order_acquire);
  return {{static_cast<std::uint16_t>(both >> kHalf), static_cast<std::uint16_t>(both)},
          since_.load(std::memory_order_relaxed)};
}

}  // namespace robotui::rt::hal
