// What a HAL and a remote joint controller send each other: one UDP packet a cycle and direction, little endian, SI
// units.
//
// hello (HAL -> joints, until a state came), command (HAL -> joints), state (joints -> HAL, the answer to each of
// both).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal::udp {

static_assert(std::endian::native == std::endian::little, "the packets are sent as they lie in memory");

inline constexpr std::uint32_t kMagic = 0x434a5452;  // "RTJC"
inline constexpr std::uint16_t kVersion = 1;
inline constexpr std::size_t kMaxPacket = 9216;

enum class Kind : std::uint16_t { kHello = 1, kCommand = 2, kState = 3 };

struct Header {
  std::uint32_t magic;
  std::uint16_t version;
  std::uint16_t kind;
  std::uint32_t session;  // another number at every start of the sender
  std::uint32_t reserved;
  std::uint64_t sequence;  // of the sender, rises by one a packet
  std::uint64_t cycle;     // of the command, and of the state that answers it
  std::uint16_t joints;    // how many of each follow
  std::uint16_t imus;
  std::uint16_t force_torques;
  std::uint16_t circuits;  // of a state: the inputs of emergency stops, 1 where a circuit is closed; else 0
};

struct JointReference {
  double position, velocity, effort, stiffness, damping;
  std::uint8_t mode;
  std::array<std::uint8_t, 7> reserved;
};

struct JointMeasurement {
  double link_position, motor_position, link_velocity, motor_velocity, effort;
  float temperature_motor, temperature_driver;
  std::uint32_t fault;
  std::uint32_t reserved;
};

static_assert(sizeof(Header) == 40 && sizeof(JointReference) == 48 && sizeof(JointMeasurement) == 56);

using Buffer = std::array<std::byte, kMaxPacket>;

// Bytes of a whole packet of that kind and those numbers.
std::size_t sizeOf(const Header& header) noexcept;

// False where it is not one of ours, of another version, or not as long as it says.
bool read(std::span<const std::byte> packet, Header& into) noexcept;

// Of a packet whose header was read. False, with nothing changed, where a number is none.
bool readReferences(std::span<const std::byte> packet, std::span<Reference> into) noexcept;
bool readState(std::span<const std::byte> packet, Measurements& into) noexcept;

// The packet lies in the buffer.
std::span<const std::byte> writeHello(Buffer& buffer, Header header) noexcept;
std::span<const std::byte> writeCommand(Buffer& buffer, Header header, std::span<const Reference> references) noexcept;
std::span<const std::byte> writeState(Buffer& buffer, Header header, const Measurements& measured) noexcept;

}  // namespace robotui::rt::hal::udp
