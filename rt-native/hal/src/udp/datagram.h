// A UDP socket that never blocks.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <netinet/in.h>

#include "robotui/rt/link/descriptor.h"

namespace robotui::rt::hal::udp {

// Throws std::runtime_error where it is no numeric IPv4 address: names would have to be asked for.
sockaddr_in addressOf(const std::string& address, std::uint16_t port);

class Datagram {
 public:
  // Takes packets of that sender alone.
  static Datagram connectedTo(const sockaddr_in& peer);
  static Datagram boundTo(const sockaddr_in& own);

  std::uint16_t port() const;  // its own
  bool send(std::span<const std::byte> packet) const noexcept;
  bool sendTo(std::span<const std::byte> packet, const sockaddr_in& to) const noexcept;

  // What of the buffer was filled; empty where nothing is there. A packet that is longer than the buffer comes cut, and
  // so is refused by its length.
  std::span<const std::byte> receive(std::span<std::byte> buffer, sockaddr_in& from) const noexcept;
  bool wait(int timeout_ms) const noexcept;

 private:
  explicit Datagram(link::Descriptor descriptor) noexcept : descriptor_(std::move(descriptor)) {}
  link::Descriptor descriptor_;
};

// Another number at each call and each start.
std::uint32_t newSession();

}  // namespace robotui::rt::hal::udp
