// What the cycle has to tell of a drive or of the bus, and the sentences of that.
#pragma once

#include <cstdint>
#include <string>

#include "drive_state.h"
#include "settings.h"

namespace robotui::rt::hal::canopen {

enum class Cause : std::uint8_t {
  kNone,
  // of one drive
  kEmergency,    // it reports an error; `detail` is the code
  kFault,        // it left "operation enabled"; `detail` is the code of its last error
  kNotEnabled,   // it does not reach "operation enabled"; `detail` is the status word
  kNoState,      // its PDOs do not come
  kNoHeartbeat,  // nor its heartbeat
  kRestarted,    // it began anew, or was put out of "operational"; `detail` is its state of NMT
  kRefusedMode,  // a plugin leads it in a way that `modes` has not; `detail` are the bits
  kIsBack,       // the PDOs and heartbeats that were missing come again
  kEnabled,      // it is in "operation enabled"
  // of the bus
  kBusOff,
  kBusDown,
  kBusFull,     // frames found no room in turn
  kBusPassive,  // many errors
  kBusBack
};

struct Alarm {
  Cause cause = Cause::kNone;
  DriveState state = DriveState::kUnknown;
  std::uint16_t drive = 0;  // index
  std::uint32_t detail = 0;
};

// For the user: what is so, and how to come back. Empty where nothing is to be said.
std::string sentenceOf(const Alarm& alarm, const Settings& settings);

}  // namespace robotui::rt::hal::canopen
