#include "bus.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

namespace robotui::rt::hal::canopen {

namespace {

constexpr int kMostBroken = 16;

[[noreturn]] void fail(const std::string& what, const std::string& remedy) {
  throw std::runtime_error(what + ": " + std::strerror(errno) + ". " + remedy);
}

link::Descriptor make(int family, int type, int protocol, const std::string& remedy) {
  link::Descriptor descriptor(::socket(family, type | SOCK_CLOEXEC | SOCK_NONBLOCK, protocol));
  if (!descriptor.isOpen()) fail("A socket of the CAN bus cannot be made", remedy);
  return descriptor;
}

Bus openSimulated(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof(address.sun_path))
    throw std::runtime_error("'unix:" + path +
                             "' is no simulated bus: write unix:PATH, with a path of at most 107 bytes.");
  std::memcpy(address.sun_path, path.data(), path.size());
  link::Descriptor descriptor = make(AF_UNIX, SOCK_SEQPACKET, 0, "");
  if (::connect(descriptor.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    fail("Nothing simulates a CAN bus at " + path, "Start robotui-rt-drives with the same configuration first.");
  return Bus(std::move(descriptor));
}

Bus openKernel(const std::string& interface) {
  const std::string up =
      "Make it ready as root: ip link set " + interface + " up type can bitrate 1000000 restart-ms 100.";
  link::Descriptor descriptor = make(
      PF_CAN, SOCK_RAW, CAN_RAW, "This kernel has no SocketCAN: load can_raw (modprobe can_raw), or use unix:PATH.");
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
  if (address.can_ifindex == 0) fail("There is no interface '" + interface + "'", up);
  const can_err_mask_t errors = CAN_ERR_BUSOFF | CAN_ERR_RESTARTED | CAN_ERR_CRTL;
  ::setsockopt(descriptor.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof(errors));
  if (::bind(descriptor.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    fail("The interface '" + interface + "' cannot be used", up);
  return Bus(std::move(descriptor));
}

bool isDown(int error) noexcept {
  return error == ENETDOWN || error == EPIPE || error == ECONNRESET || error == ENOTCONN || error == ENODEV ||
         error == ENXIO;
}

}  // namespace

Bus Bus::open(const std::string& interface) {
  return interface.starts_with(kSimulatedBus) ? openSimulated(interface.substr(kSimulatedBus.size()))
                                              : openKernel(interface);
}

void Bus::hearOnly(canid_t id, canid_t mask) const noexcept {
  const can_filter filter{id, mask};
  ::setsockopt(descriptor_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, &filter, sizeof(filter));
}

Sent Bus::send(const Frame& frame) const noexcept {
  const ssize_t length = ::send(descriptor_.get(), &frame, sizeof(frame), MSG_NOSIGNAL);
  if (length == static_cast<ssize_t>(sizeof(frame))) return Sent::kYes;
  return length < 0 && isDown(errno) ? Sent::kDown : Sent::kFull;
}

Heard Bus::receive(Frame& into) const noexcept {
  for (int i = 0; i < kMostBroken; ++i) {
    const ssize_t length = ::recv(descriptor_.get(), &into, sizeof(into), MSG_TRUNC);
    if (length == static_cast<ssize_t>(sizeof(into)) && into.can_dlc <= CAN_MAX_DLEN) return Heard::kFrame;
    if (length == 0) return Heard::kDown;
    if (length < 0 && errno != EINTR) return isDown(errno) ? Heard::kDown : Heard::kNothing;
  }
  return Heard::kNothing;
}

bool Bus::wait(int timeout_ms) const noexcept {
  pollfd poll{descriptor_.get(), POLLIN, 0};
  return ::poll(&poll, 1, timeout_ms) > 0;
}

}  // namespace robotui::rt::hal::canopen
