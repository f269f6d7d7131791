#include "supervision.h"

#include <cstdio>
#include <stdexcept>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::chrono::milliseconds kBegin{5000};

}  // namespace

Supervision::Supervision(int control) {
  if (control < 0) return;
  socket_ = link::Socket(link::Descriptor(control));
  link::Packet begin;
  if (socket_.receive(begin, kBegin) != link::Received::kPacket || begin.verb() != "begin" ||
      begin.descriptors.empty()) {
    throw std::runtime_error("The supervisor gave no memory for topics of plugins.");
  }
  own_ = link::Segment<link::ChannelSegment>::open(std::move(begin.descriptors.front()));
  for (std::size_t i = 1; i < begin.descriptors.size(); ++i) {
    hosts_.push_back(link::Segment<const link::ChannelSegment>::openAsItIs(std::move(begin.descriptors[i])));
  }
}

std::vector<const link::ChannelSegment*> Supervision::hosts() const {
  std::vector<const link::ChannelSegment*> all;
  for (const auto& host : hosts_) all.push_back(host.get());
  return all;
}

void Supervision::say(const char* level, const std::string& line) {
  const std::scoped_lock lock(mutex_);
  if (!socket_.isOpen()) {
    std::fprintf(stderr, "%s: %s\n", level, line.c_str());
  } else {
    socket_.send("log " + std::string(level) + " " + line.substr(0, 4000));
  }
}

bool Supervision::goesOn() {
  if (!socket_.isOpen()) return true;
  const std::int64_t now = link::now();
  if (now - alive_ns_ > link::kSecond) {
    alive_ns_ = now;
    const std::scoped_lock lock(mutex_);
    socket_.send("alive");
  }
  link::Packet packet;
  const link::Received received = socket_.receive(packet, std::chrono::milliseconds(0));
  return received == link::Received::kTimeout || (received == link::Received::kPacket && packet.verb() != "end");
}

}  // namespace robotui::rt::ros_bridge
