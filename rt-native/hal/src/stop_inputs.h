// The emergency stops in the cycle: what their inputs say, and what is to be told of it.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "robotui/rt/hal/hal.h"
#include "robotui/rt/link/stop_bits.h"

namespace robotui::rt::hal {

// Which emergency stops kept the robot safe since the last look, and since which cycle.
struct StopReport {
  link::StopBits bits;
  std::uint64_t cycle = 0;
};

class StopInputs {
 public:
  // One that cannot be read is told no sooner than after so many cycles, since buses take their time to begin.
  StopInputs(std::size_t count, std::uint64_t unread_after) : inputs_(count), unread_after_(unread_after) {}

  // ---- on the real-time thread, once a cycle
  void look(Hal& hal, std::uint64_t cycle) noexcept;
  bool isStopped() const noexcept { return bits_.any(); }
  bool isPressed() const noexcept { return bits_.pressed != 0; }
  bool wasReleased() const noexcept { return was_stopped_ && !isStopped(); }  // in this cycle
  const link::StopBits& bits() const noexcept { return bits_; }

  // ---- on one ordinary thread: one that was pressed shortly is told, too
  StopReport take() noexcept;

 private:
  void tell(std::uint64_t cycle) noexcept;

  std::vector<StopInput> inputs_;
  std::uint64_t unread_after_;
  std::uint16_t known_ = 0;  // that were read once
  link::StopBits bits_{};
  bool was_stopped_ = false;
  std::atomic<std::uint32_t> now_{0};
  std::atomic<std::uint32_t> seen_{0};  // since the last look
  std::atomic<std::uint64_t> since_{0};
};

}  // namespace robotui::rt::hal
