#include "robotui/rt/supervisor/ros_supervisor.h"

#include "numbers.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {

void RosSupervisor::spawn(std::int64_t now_ns) {
  const std::vector<link::Descriptor> channels = hosts_.shareChannels();
  std::vector<std::string> arguments = childArguments(options_);
  if (!options_.name.empty()) {
    arguments.insert(arguments.end(), {"--name", options_.name});
  }
  ros_.spawn(arguments, numbersOf(channels), now_ns);
}

void RosSupervisor::receive() {
  link::Packet packet;
  while (ros_.child().socket().isOpen() &&
         ros_.child().socket().receive(packet, std::chrono::milliseconds(0)) == link::Received::kPacket) {
    if (packet.verb() == "alive") {
      ros_.alive(link::now());
    } else if (packet.verb() == "log") {
      log_.relay({}, packet.rest());
    }
  }
}

void RosSupervisor::turn(std::int64_t now_ns, bool serving) {
  if (!ros_.isWanted()) {
    return;
  }
  receive();
  if (const auto how = ros_.child().end()) {
    receive();
    log_.warn("The ROS process " + *how + ".");
    const std::string more = ros_.ended(now_ns);
    if (!more.empty()) {
      log_.error(more);
    }
  }
  ros_.watch(now_ns);
  if (serving && ros_.isDue(now_ns) && ros_.lack().empty()) {
    spawn(now_ns);
  }
}

}  // namespace robotui::rt::supervisor
