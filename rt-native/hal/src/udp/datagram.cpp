#include "datagram.h"

#include <cerrno>
#include <cstring>
#include <random>
#include <stdexcept>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

namespace robotui::rt::hal::udp {

namespace {

std::string nameOf(const sockaddr_in& address) {
  char text[INET_ADDRSTRLEN];
  ::inet_ntop(AF_INET, &address.sin_addr, text, sizeof(text));
  return std::string(text) + ":" + std::to_string(ntohs(address.sin_port));
}

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what + ": " + std::strerror(errno) + "."); }

link::Descriptor make() {
  link::Descriptor descriptor(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!descriptor.isOpen()) fail("A UDP socket cannot be made");
  return descriptor;
}

const sockaddr* plain(const sockaddr_in& address) noexcept { return reinterpret_cast<const sockaddr*>(&address); }

}  // namespace

sockaddr_in addressOf(const std::string& address, std::uint16_t port) {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_port = htons(port);
  if (::inet_pton(AF_INET, address.c_str(), &result.sin_addr) != 1) {
    throw std::runtime_error("'" + address + "' is no address: write an IPv4 address such as 192.168.1.10.");
  }
  return result;
}

Datagram Datagram::connectedTo(const sockaddr_in& peer) {
  Datagram result(make());
  if (::connect(result.descriptor_.get(), plain(peer), sizeof(peer)) != 0) fail("Cannot send to " + nameOf(peer));
  return result;
}

Datagram Datagram::boundTo(const sockaddr_in& own) {
  Datagram result(make());
  if (::bind(result.descriptor_.get(), plain(own), sizeof(own)) != 0) fail("Cannot listen on " + nameOf(own));
  return result;
}

std::uint16_t Datagram::port() const {
  sockaddr_in own{};
  socklen_t size = sizeof(own);
  ::getsockname(descriptor_.get(), reinterpret_cast<sockaddr*>(&own), &size);
  return ntohs(own.sin_port);
}

bool Datagram::send(std::span<const std::byte> packet) const noexcept {
  return ::send(descriptor_.get(), packet.data(), packet.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(packet.size());
}

bool Datagram::sendTo(std::span<const std::byte> packet, const sockaddr_in& to) const noexcept {
  return ::sendto(descriptor_.get(), packet.data(), packet.size(), MSG_NOSIGNAL, plain(to), sizeof(to)) ==
         static_cast<ssize_t>(packet.size());
}

// A refusal that comes back from a peer that does not listen ends one call of recvfrom: what waits behind it is taken
// by the next.
std::span<const std::byte> Datagram::receive(std::span<std::byte> buffer, sockaddr_in& from) const noexcept {
  for (int i = 0; i < 2; ++i) {
    socklen_t size = sizeof(from);
    const ssize_t length =
        ::recvfrom(descriptor_.get(), buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (length >= 0) return buffer.first(static_cast<std::size_t>(length));
    if (errno != ECONNREFUSED && errno != EINTR) break;
  }
  return {};
}

bool Datagram::wait(int timeout_ms) const noexcept {
  pollfd poll{descriptor_.get(), POLLIN, 0};
  return ::poll(&poll, 1, timeout_ms) > 0;
}

std::uint32_t newSession() { return std::random_device()(); }

}  // namespace robotui::rt::hal::udp
