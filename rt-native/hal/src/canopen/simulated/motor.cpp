#include "motor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robotui::rt::hal::canopen::simulated {

namespace {

constexpr std::uint16_t kTargetReached = 0x0400;
constexpr std::uint16_t kRemote = 0x0200;
constexpr std::uint16_t kVoltage = 0x0010;
constexpr double kTorqueGain = 20;  // counts/s^2 of a thousandth of the rated torque
constexpr double kFriction = 2;     // 1/s

std::uint16_t bitsOf(DriveState state) noexcept {
  switch (state) {
    case DriveState::kSwitchOnDisabled: return 0x40;
    case DriveState::kReadyToSwitchOn: return 0x21;
    case DriveState::kSwitchedOn: return 0x23;
    case DriveState::kEnabled: return 0x27;
    case DriveState::kQuickStop: return 0x07;
    case DriveState::kFault: return 0x08;
    default: return 0x00;
  }
}

// One transition for each control word, as the profile has them.
DriveState next(DriveState state, std::uint16_t word) noexcept {
  const bool voltage = (word & 0x02U) != 0;
  const bool quick_stop_off = (word & 0x04U) != 0;
  if (!voltage) return DriveState::kSwitchOnDisabled;
  if (!quick_stop_off) return state == DriveState::kEnabled ? DriveState::kQuickStop : DriveState::kSwitchOnDisabled;
  if (state == DriveState::kQuickStop) return state;
  const bool on = (word & 0x01U) != 0;
  if (!on) return DriveState::kReadyToSwitchOn;
  switch (state) {
    case DriveState::kReadyToSwitchOn: return DriveState::kSwitchedOn;
    case DriveState::kSwitchedOn:
    case DriveState::kEnabled: return (word & 0x08U) != 0 ? DriveState::kEnabled : DriveState::kSwitchedOn;
    default: return state;
  }
}

}  // namespace

void Motor::control(std::uint16_t control_word) noexcept {
  const bool reset_edge = (control_word & kResetFault & ~control_word_) != 0;
  control_word_ = control_word;
  if (state_ == DriveState::kFault) {
    if (!reset_edge) return;
    state_ = DriveState::kSwitchOnDisabled;
    was_reset_ = true;
  } else {
    state_ = blocked_ ? DriveState::kSwitchOnDisabled : next(state_, control_word);
  }
}

void Motor::block(bool blocked) noexcept {
  blocked_ = blocked;
  if (blocked && state_ != DriveState::kFault) state_ = DriveState::kSwitchOnDisabled;
}

bool Motor::wasReset() noexcept { return std::exchange(was_reset_, false); }

void Motor::move(const Target& target, double seconds) noexcept {
  const double before = position_;
  torque_ = 0;
  if (state_ != DriveState::kEnabled || !(seconds > 0)) {
    velocity_ = 0;
    return;
  }
  switch (static_cast<OperationMode>(target.mode)) {
    case OperationMode::kSyncPosition: position_ = target.position; break;
    case OperationMode::kSyncVelocity: position_ += target.velocity * seconds; break;
    case OperationMode::kSyncTorque:
      torque_ = target.torque;
      position_ += (velocity_ + target.torque * kTorqueGain * seconds) / (1 + kFriction * seconds) * seconds;
      break;
    default: break;
  }
  velocity_ = (position_ - before) / seconds;
}

std::uint16_t Motor::statusWord() const noexcept {
  const bool has_voltage = !blocked_;
  return static_cast<std::uint16_t>(bitsOf(state_) | kRemote | (has_voltage ? kVoltage : 0) |
                                    (velocity_ == 0 ? kTargetReached : 0));
}

std::int32_t Motor::position() const noexcept {
  return static_cast<std::int32_t>(std::lround(std::clamp(position_, -2147483647.0, 2147483647.0)));
}

}  // namespace robotui::rt::hal::canopen::simulated
