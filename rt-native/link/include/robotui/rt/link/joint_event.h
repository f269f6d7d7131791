// What the loop of the HAL has to say of joints: that they fell into their safe state, or that a command was refused.
// Made on the real-time thread, sent as text by the ordinary one, read by the supervisor.
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/stop_bits.h"

namespace robotui::rt::link {

// Why joints became safe.
enum class FallCause : std::uint8_t {
  kNone = 0,       // they did not: a command was refused
  kMissed = 1,     // their plugin's thread did not answer
  kRejected = 2,   // what it commanded was refused again and again
  kHardware = 3,   // the hardware was silent
  kFollowing = 4,  // a joint was too far from its reference
  kEmergency = 5,  // an emergency stop is pressed, or cannot be read
};

// Why a command was refused.
enum class Objection : std::uint8_t {
  kNone = 0,
  kNotOwner = 1,
  kUnknownMode = 2,
  kNoNumber = 3,
  kBadGain = 4,  // a stiffness or a damping that is negative or no number
};

struct JointEvent {
  FallCause cause = FallCause::kNone;
  Objection objection = Objection::kNone;
  std::uint16_t plugin = kNobody;    // by its index on the board
  std::uint16_t joint = 0;           // that it began with
  std::uint32_t grant = 0;           // of that joint: an older one than the board's is of a start before
  std::uint32_t rejected = 0;        // commands of that joint so far
  std::uint64_t cycle = 0;           // of the HAL
  double error = 0;                  // rad or m, of kFollowing
  StopBits stops{};                  // of kEmergency
  std::bitset<kMaxJoints> joints{};  // all that fell
};

// A packet of the socket: "joints CAUSE OBJECTION PLUGIN JOINT GRANT REJECTED CYCLE ERROR PRESSED UNREAD JOINTS".
std::string textOf(const JointEvent& event);

// Nothing where the words behind the verb are not those of an event.
std::optional<JointEvent> jointEventOf(std::string_view words);

}  // namespace robotui::rt::link
