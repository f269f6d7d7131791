#include "drive_state.h"

namespace robotui::rt::hal::canopen {

namespace {

struct Pattern {
  std::uint16_t mask;
  std::uint16_t value;
  DriveState state;
};

constexpr Pattern kPatterns[] = {
    {0x4f, 0x00, DriveState::kNotReady},        {0x4f, 0x40, DriveState::kSwitchOnDisabled},
    {0x6f, 0x21, DriveState::kReadyToSwitchOn}, {0x6f, 0x23, DriveState::kSwitchedOn},
    {0x6f, 0x27, DriveState::kEnabled},         {0x6f, 0x07, DriveState::kQuickStop},
    {0x4f, 0x0f, DriveState::kFaultReaction},   {0x4f, 0x08, DriveState::kFault},
};

}  // namespace

DriveState stateOf(std::uint16_t status_word) noexcept {
  for (const Pattern& pattern : kPatterns)
    if ((status_word & pattern.mask) == pattern.value) return pattern.state;
  return DriveState::kUnknown;
}

std::uint16_t towardsEnabled(DriveState state, bool edge) noexcept {
  switch (state) {
    case DriveState::kSwitchOnDisabled: return kShutDown;
    case DriveState::kReadyToSwitchOn: return kSwitchOn;
    case DriveState::kSwitchedOn:
    case DriveState::kEnabled: return kEnable;
    case DriveState::kFault: return edge ? kResetFault : kDisableVoltage;
    default: return kDisableVoltage;
  }
}

const char* nameOf(DriveState state) noexcept {
  switch (state) {
    case DriveState::kNotReady: return "not ready to switch on";
    case DriveState::kSwitchOnDisabled: return "switch on disabled";
    case DriveState::kReadyToSwitchOn: return "ready to switch on";
    case DriveState::kSwitchedOn: return "switched on";
    case DriveState::kEnabled: return "operation enabled";
    case DriveState::kQuickStop: return "quick stop active";
    case DriveState::kFaultReaction: return "fault reaction active";
    case DriveState::kFault: return "fault";
    default: return "a state that CiA 402 does not know";
  }
}

const char* hintFor(DriveState state) noexcept {
  switch (state) {
    case DriveState::kNotReady: return "it still starts, or its logic supply is too low";
    case DriveState::kSwitchOnDisabled: return "look at the motor supply, at STO and at its enable input";
    case DriveState::kReadyToSwitchOn: return "look at the motor supply and at the brake";
    case DriveState::kSwitchedOn: return "look at its enable input, at the brake and at the mode of operation";
    case DriveState::kFaultReaction:
    case DriveState::kFault:
      return "the cause of the fault is still there, or the drive wants to be switched off and on";
    default: return "look at its manual";
  }
}

}  // namespace robotui::rt::hal::canopen
