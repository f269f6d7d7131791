// Which process data objects of a drive carry what, and where in them.
#pragma once

#include <array>
#include <cstdint>

#include "frame.h"
#include "objects.h"

namespace robotui::rt::hal::canopen {

class SdoClient;

inline constexpr std::size_t kPdos = 4;  // in each direction

// Whole bytes of one PDO.
struct Field {
  std::uint8_t pdo = kPdos;  // index; kPdos is none
  std::uint8_t offset = 0;
  std::uint8_t size = 0;
  bool isThere() const noexcept { return pdo < kPdos; }
  friend bool operator==(const Field&, const Field&) = default;
};

struct Pdo {
  canid_t id = 0;  // 0 is not used
  std::uint8_t length = 0;
  friend bool operator==(const Pdo&, const Pdo&) = default;
};

struct PdoLayout {
  std::array<Pdo, kPdos> receive;   // what the drive receives
  std::array<Pdo, kPdos> transmit;  // what it sends
  Field control_word, mode, target_position, target_velocity, target_torque;
  Field status_word, mode_shown, position, velocity, torque, inputs;
  friend bool operator==(const PdoLayout&, const PdoLayout&) = default;

  std::size_t frames() const noexcept;  // in a cycle
};

// What a drive is to do, and to say.
struct Ways {
  bool position = true;
  bool velocity = false;
  bool effort = false;
  bool inputs = false;  // an emergency stop is wired to its digital inputs
  int count() const noexcept { return int{position} + int{velocity} + int{effort}; }
};

// As the drive says now. Throws SdoError, and std::runtime_error with a part of a sentence where something needed is
// not in it.
PdoLayout readLayout(const SdoClient& sdo, const Ways& ways);

// Writes the layout that we take where the user leaves it to us. Throws SdoError.
void writeLayout(const SdoClient& sdo, std::uint8_t node, const Ways& ways);

}  // namespace robotui::rt::hal::canopen
