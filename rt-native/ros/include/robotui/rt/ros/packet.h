// What passes between a plugin and the ROS process: serialised messages in channels, each written by one side.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "robotui/rt/plugin/channel.h"

namespace robotui::rt::ros {

inline constexpr std::size_t kMostPorts = 24;  // of one plugin

// A value of a channel: as many as fit are kept.
template <std::size_t Bytes>
struct Packet {
  static constexpr Schema kSchema{"robotui/ros/packet", 1};
  static constexpr std::size_t kRoom = Bytes - 16;
  static constexpr std::uint32_t kDepth = static_cast<std::uint32_t>(kChannelWords / (Bytes / 8 + 1));
  std::uint32_t size;    // of data, bytes; more than kRoom is not valid
  std::uint32_t number;  // of a call, or of a parameter
  std::uint64_t flags;   // 1: a service succeeded
  std::array<std::uint8_t, kRoom> data;

  std::span<const std::uint8_t> bytes() const noexcept { return {data.data(), std::min<std::size_t>(size, kRoom)}; }
};

using SmallPacket = Packet<1016>;  // 8 are kept
using LargePacket = Packet<4080>;  // 2 are kept
using AnnouncedPacket = Packet<8176>;
inline constexpr std::uint64_t kSucceeded = 1;

enum class PortKind : std::uint8_t { kPublish = 1, kSubscribe = 2, kServe = 3, kTune = 4 };

// A channel of one port. `back` is the direction from the ROS process to the plugin.
inline std::string channelName(std::string_view plugin, std::size_t port, bool back) {
  return "ros/" + std::string(plugin) + "/" + std::to_string(port) + (back ? "/in" : "/out");
}
inline std::string announcementName(std::string_view plugin, std::size_t port) {
  return "ros/" + std::string(plugin) + "/" + std::to_string(port);
}

// Written over and over by one side, in order, and read by the other; of the size that the port was announced with.
class PacketWriter {
 public:
  PacketWriter() = default;
  PacketWriter(ChannelDirectory& directory, const std::string& name, bool large) {
    if (large) {
      large_ = ChannelWriter<LargePacket>(directory, name, LargePacket::kDepth);
    } else {
      small_ = ChannelWriter<SmallPacket>(directory, name, SmallPacket::kDepth);
    }
    is_large_ = large;
  }
  std::size_t room() const noexcept { return is_large_ ? LargePacket::kRoom : SmallPacket::kRoom; }

  // `fill` gets the room and writes `size` bytes.
  template <typename Fill>
  void write(std::size_t size, std::uint32_t number, std::uint64_t flags, Fill&& fill) {
    if (is_large_) {
      put(large_, large_packet_, size, number, flags, fill);
    } else {
      put(small_, small_packet_, size, number, flags, fill);
    }
  }
  void write(std::span<const std::uint8_t> bytes, std::uint32_t number = 0, std::uint64_t flags = 0) {
    write(bytes.size(), number, flags, [&](std::uint8_t* into) { std::copy(bytes.begin(), bytes.end(), into); });
  }

 private:
  template <typename P, typename Fill>
  static void put(ChannelWriter<P>& writer, P& packet, std::size_t size, std::uint32_t number, std::uint64_t flags,
                  Fill& fill) {
    packet.size = static_cast<std::uint32_t>(size);
    packet.number = number;
    packet.flags = flags;
    fill(packet.data.data());
    writer.write(packet);
  }

  bool is_large_ = false;
  ChannelWriter<SmallPacket> small_;
  ChannelWriter<LargePacket> large_;
  SmallPacket small_packet_{};
  LargePacket large_packet_{};
};

// A port that was small and is large now may still have its old writer for a moment.
class PacketReader {
 public:
  PacketReader() = default;
  PacketReader(const ChannelDirectory& directory, const std::string& name, bool large)
      : is_large_(large),
        small_(large ? ChannelReader<SmallPacket>() : ChannelReader<SmallPacket>(directory, name, OtherSchema::kAwait)),
        large_(large ? ChannelReader<LargePacket>(directory, name, OtherSchema::kAwait)
                     : ChannelReader<LargePacket>()) {}

  // The next one, valid until the next call; false where there is none.
  bool next() noexcept { return is_large_ ? large_.next(large_packet_) : small_.next(small_packet_); }
  std::span<const std::uint8_t> bytes() const noexcept {
    return is_large_ ? large_packet_.bytes() : small_packet_.bytes();
  }
  std::uint32_t number() const noexcept { return is_large_ ? large_packet_.number : small_packet_.number; }
  std::uint64_t flags() const noexcept { return is_large_ ? large_packet_.flags : small_packet_.flags; }
  std::uint64_t lost() const noexcept { return is_large_ ? large_.lost() : small_.lost(); }

 private:
  bool is_large_ = false;
  ChannelReader<SmallPacket> small_;
  ChannelReader<LargePacket> large_;
  SmallPacket small_packet_{};
  LargePacket large_packet_{};
};

}  // namespace robotui::rt::ros
