#include "simulated_bus.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::canopen::simulated {

namespace {

constexpr std::size_t kMostMembers = 32;
constexpr int kMostFrames = 256;  // of one member at once

link::Descriptor listenAt(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof(address.sun_path))
    throw std::runtime_error("'" + path + "' cannot be the path of a simulated bus: it has from 1 to 107 bytes.");
  std::memcpy(address.sun_path, path.data(), path.size());
  link::Descriptor door(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const auto* plain = reinterpret_cast<const sockaddr*>(&address);
  if (door.isOpen() && ::connect(door.get(), plain, sizeof(address)) != 0 && errno == ECONNREFUSED)
    ::unlink(path.c_str());  // of one that ended without tidying up
  if (!door.isOpen() || ::bind(door.get(), plain, sizeof(address)) != 0 || ::listen(door.get(), 8) != 0)
    throw std::runtime_error("A simulated bus cannot be made at " + path + ": " + std::strerror(errno) + ".");
  return door;
}

}  // namespace

SimulatedBus::SimulatedBus(const std::string& interface) {
  if (!interface.starts_with(kSimulatedBus)) {
    members_.push_back(Bus::open(interface));
    return;
  }
  const std::string path = interface.substr(kSimulatedBus.size());
  door_ = listenAt(path);
  path_ = path;
}

SimulatedBus::~SimulatedBus() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

Drive& SimulatedBus::add(std::uint8_t node, double position_counts) {
  drives_.push_back(std::make_unique<Drive>(node, position_counts, [this](const Frame& frame) { send(frame); }));
  return *drives_.back();
}

// Who does not read misses frames, as on a wire.
void SimulatedBus::send(const Frame& frame) {
  for (const Bus& member : members_) member.send(frame);
}

void SimulatedBus::wait(int timeout_ms) const {
  std::vector<pollfd> polls;
  if (door_.isOpen()) polls.push_back({door_.get(), POLLIN, 0});
  for (const Bus& member : members_) polls.push_back({member.descriptor(), POLLIN, 0});
  ::poll(polls.data(), polls.size(), timeout_ms);
}

void SimulatedBus::join() {
  while (door_.isOpen() && members_.size() < kMostMembers) {
    link::Descriptor member(::accept4(door_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!member.isOpen()) return;
    members_.emplace_back(std::move(member));
  }
}

// False where it has left.
bool SimulatedBus::pass(std::size_t member) {
  Frame frame{};
  for (int i = 0; i < kMostFrames; ++i) {
    const Heard heard = members_[member].receive(frame);
    if (heard != Heard::kFrame) return heard != Heard::kDown || path_.empty();
    for (std::size_t other = 0; other < members_.size(); ++other)
      if (other != member) members_[other].send(frame);
    for (const auto& drive : drives_) drive->heard(frame, link::now());
  }
  return true;
}

void SimulatedBus::step(int timeout_ms) {
  wait(timeout_ms);
  join();
  for (std::size_t member = 0; member < members_.size();)
    if (pass(member))
      ++member;
    else
      members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(member));
  for (const auto& drive : drives_) drive->step(link::now());
}

}  // namespace robotui::rt::hal::canopen::simulated
