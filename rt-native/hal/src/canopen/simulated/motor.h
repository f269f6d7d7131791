// What a simulated drive does with its motor: the state machine of CiA 402, and motion.
#pragma once

#include <cstdint>

#include "../drive_state.h"
#include "../objects.h"

namespace robotui::rt::hal::canopen::simulated {

struct Target {
  std::int8_t mode;
  std::int32_t position;  // counts
  std::int32_t velocity;  // counts/s
  std::int16_t torque;    // of a thousand
};

class Motor {
 public:
  explicit Motor(double position_counts) noexcept : position_(position_counts) {}

  void control(std::uint16_t control_word) noexcept;
  void move(const Target& target, double seconds) noexcept;

  // Until the control resets it by a rising edge of bit 7.
  void fail() noexcept { state_ = DriveState::kFault; }
  // STO, or no supply: it does not leave "switch on disabled".
  void block(bool blocked) noexcept;

  DriveState state() const noexcept { return state_; }
  bool wasReset() noexcept;  // since the last call
  std::uint16_t statusWord() const noexcept;
  std::int32_t position() const noexcept;
  std::int32_t velocity() const noexcept { return static_cast<std::int32_t>(velocity_); }
  std::int16_t torque() const noexcept { return torque_; }

 private:
  double position_;
  double velocity_ = 0;
  std::int16_t torque_ = 0;
  std::uint16_t control_word_ = 0;
  DriveState state_ = DriveState::kSwitchOnDisabled;
  bool blocked_ = false;
  bool was_reset_ = false;
};

}  // namespace robotui::rt::hal::canopen::simulated
