// The state machine of a drive (CiA 402): what its status word says, and what to tell it next.
#pragma once

#include <cstdint>

namespace robotui::rt::hal::canopen {

enum class DriveState : std::uint8_t {
  kNotReady,
  kSwitchOnDisabled,
  kReadyToSwitchOn,
  kSwitchedOn,
  kEnabled,
  kQuickStop,
  kFaultReaction,
  kFault,
  kUnknown  // bits that no state has
};

inline constexpr std::uint16_t kDisableVoltage = 0x0000;
inline constexpr std::uint16_t kShutDown = 0x0006;
inline constexpr std::uint16_t kSwitchOn = 0x0007;
inline constexpr std::uint16_t kEnable = 0x000f;
inline constexpr std::uint16_t kResetFault = 0x0080;

DriveState stateOf(std::uint16_t status_word) noexcept;

// One step on the way to "operation enabled". A fault is reset by a rising edge: `edge` is to change from call to call.
std::uint16_t towardsEnabled(DriveState state, bool edge) noexcept;

// As CiA 402 calls it, such as "switch on disabled".
const char* nameOf(DriveState state) noexcept;

// What a user can look for where a drive does not leave this state.
const char* hintFor(DriveState state) noexcept;

}  // namespace robotui::rt::hal::canopen
