// The ROS process as a plugin under test sees it: writes into channels and reads what the plugin says.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include <ros/serialization.h>

#include "robotui/rt/ros/announcement.h"
#include "robotui/rt/testing/fake_setup.h"

namespace robotui::rt::ros {

inline bool eventually(const std::function<bool()>& condition) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

class FarSide {
 public:
  explicit FarSide(testing::FakeSetup& setup) : setup_(setup) {}

  Announcement announced(std::size_t port) {
    ChannelReader<AnnouncedPacket> reader(setup_.channels(), announcementName(setup_.name(), port));
    const auto packet = std::make_unique<AnnouncedPacket>();
    if (!reader.latest(*packet)) throw std::runtime_error("nothing is announced");
    return readAnnouncement(packet->bytes());
  }
  PacketWriter to(std::size_t port, bool large = false) {
    return {setup_.channels(), channelName(setup_.name(), port, true), large};
  }
  PacketReader from(std::size_t port, bool large = false) {
    return {setup_.channels(), channelName(setup_.name(), port, false), large};
  }

 private:
  testing::FakeSetup& setup_;
};

template <typename Message>
std::vector<std::uint8_t> bytesOf(const Message& message) {
  std::vector<std::uint8_t> bytes(::ros::serialization::serializationLength(message));
  ::ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ::ros::serialization::serialize(stream, message);
  return bytes;
}

template <typename Message>
Message messageOf(std::span<const std::uint8_t> bytes) {
  Message message;
  ::ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.data()),
                                       static_cast<std::uint32_t>(bytes.size()));
  ::ros::serialization::deserialize(stream, message);
  return message;
}

}  // namespace robotui::rt::ros
