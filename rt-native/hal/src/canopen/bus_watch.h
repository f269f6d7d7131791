// Whether the bus itself works, by its frames of errors and by what becomes of ours.
#pragma once

#include <cstdint>

#include "alarm.h"
#include "bus.h"

namespace robotui::rt::hal::canopen {

// On the real-time thread.
class BusWatch {
 public:
  // So many cycles in turn without room for our frames, and the bus does not work.
  explicit BusWatch(std::uint32_t full_cycles) noexcept : full_cycles_(full_cycles) {}

  void heard(const Frame& frame) noexcept;
  void heardDown() noexcept { down_ = true; }
  // False where there is no room for more in this cycle.
  bool sent(Sent outcome) noexcept;

  // Once a cycle: what is new to tell.
  Alarm look() noexcept;
  bool works() const noexcept { return told_ == Cause::kNone; }

 private:
  Cause now() const noexcept;

  std::uint32_t full_cycles_;
  std::uint32_t full_ = 0;  // cycles in turn
  bool had_no_room_ = false;
  bool off_ = false;
  bool down_ = false;
  bool passive_ = false;
  Cause told_ = Cause::kNone;
};

}  // namespace robotui::rt::hal::canopen
