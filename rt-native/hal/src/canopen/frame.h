// A frame of the bus as the kernel has it, and what CANopen (CiA 301) means by its identifier.
#pragma once

#include <cstdint>
#include <initializer_list>

#include <linux/can.h>

namespace robotui::rt::hal::canopen {

using Frame = ::can_frame;

inline constexpr canid_t kNmtId = 0x000;
inline constexpr canid_t kSyncId = 0x080;
inline constexpr canid_t kEmergencyId = 0x080;  // the following ones are those of node 0: a node adds its number
inline constexpr canid_t kSdoAnswerId = 0x580;
inline constexpr canid_t kSdoRequestId = 0x600;
inline constexpr canid_t kHeartbeatId = 0x700;
inline constexpr std::size_t kIdentifiers = 0x800;

enum class NmtCommand : std::uint8_t {
  kStart = 0x01,
  kStop = 0x02,
  kPreOperational = 0x80,
  kResetNode = 0x81,
  kResetCommunication = 0x82
};

enum class NmtState : std::uint8_t { kBootUp = 0x00, kStopped = 0x04, kOperational = 0x05, kPreOperational = 0x7f };

inline Frame frameOf(canid_t id, std::initializer_list<std::uint8_t> bytes) noexcept {
  Frame frame{};
  frame.can_id = id;
  for (const std::uint8_t byte : bytes)
    if (frame.can_dlc < CAN_MAX_DLEN) frame.data[frame.can_dlc++] = byte;
  return frame;
}

inline Frame nmtFrame(NmtCommand command, std::uint8_t node) noexcept {
  return frameOf(kNmtId, {static_cast<std::uint8_t>(command), node});
}

// Little endian; what lies beyond a frame is not written, and read as zero.
inline void put(Frame& frame, std::size_t offset, std::size_t size, std::uint32_t value) noexcept {
  for (std::size_t i = 0; i < size && offset + i < CAN_MAX_DLEN; ++i)
    frame.data[offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

inline std::uint32_t get(const Frame& frame, std::size_t offset, std::size_t size) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size && i < 4 && offset + i < CAN_MAX_DLEN; ++i)
    value |= std::uint32_t{frame.data[offset + i]} << (8 * i);
  return value;
}

// A frame of 11 bits with data, and no frame of errors: all that CANopen has.
inline bool isPlain(const Frame& frame) noexcept {
  return (frame.can_id & (CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_ERR_FLAG)) == 0 && frame.can_dlc <= CAN_MAX_DLEN;
}

}  // namespace robotui::rt::hal::canopen
