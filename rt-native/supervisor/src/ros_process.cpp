#include "robotui/rt/link/clock.h"
#include "robotui/rt/supervisor/supervisor.h"

namespace robotui::rt::supervisor {

void Supervisor::spawnRos(std::int64_t now) {
  std::vector<link::Descriptor> shared;
  std::vector<int> given;
  for (const auto& host : hosts_) {
    given.push_back(shared.emplace_back(host->channels().shareReadOnly()).get());
  }
  std::vector<std::string> arguments = childArguments(options_);
  if (!options_.name.empty()) {
    arguments.insert(arguments.end(), {"--name", options_.name});
  }
  ros_.spawn(arguments, given, now);
}

void Supervisor::hearRos() {
  link::Packet packet;
  while (ros_.child().socket().isOpen() && ros_.child().socket().receive(packet, std::chrono::milliseconds(0)) == link::Received::kPacket) {
    if (packet.verb() == "alive") {
      ros_.alive(link::now());
    } else if (packet.verb() == "log") {
      log({}, packet.rest());
    }
  }
}

// Whatever becomes of it, the robot goes on.
void Supervisor::keepRos(std::int64_t now) {
  if (!ros_.isWanted() || ending_) {
    return;
  }
  hearRos();
  if (const auto how = ros_.child().end()) {
    hearRos();
    journal_.warn("The ROS process " + *how + ".");
    const std::string more = ros_.died(now);
    if (!more.empty()) {
      journal_.error(more);
    }
  }
  ros_.watch(now);
  if (serving_ && ros_.isDue(now) && ros_.lack().empty()) {
    spawnRos(now);
  }
}

}  // namespace robotui::rt::supervisor
