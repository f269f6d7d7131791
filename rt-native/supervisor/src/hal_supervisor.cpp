#include "robotui/rt/supervisor/hal_supervisor.h"

#include "numbers.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {

void HalSupervisor::spawn() {
  std::vector<link::Descriptor> shared = hosts_.shareSegments();
  shared.insert(shared.begin(), board_.share());
  std::vector<std::string> arguments = childArguments(options_);
  if (options_.allow_non_rt) {
    arguments.emplace_back("--allow-non-rt");
  }
  if (options_.nrt) {
    arguments.emplace_back("--nrt");
  }
  hal_.spawn(arguments, numbersOf(shared));
  board_.edit().hal_pid = hal_.child().pid();
}

bool HalSupervisor::turn(bool serving) {
  receive();
  const auto how = hal_.child().end();
  return !how || ended(*how, serving);
}

void HalSupervisor::receive() {
  link::Packet packet;
  while (hal_.child().socket().isOpen() &&
         hal_.child().socket().receive(packet, std::chrono::milliseconds(0)) == link::Received::kPacket) {
    if (packet.verb() == "log") {
      log_.relay("hal", packet.rest());
      continue;
    }
    if (packet.verb() == "joints") {
      joints_.handle(packet.rest(), link::now());
      continue;
    }
    if (packet.verb() == "stops") {
      stops_.handle(packet.rest());
      continue;
    }
    if (packet.verb() == "switched") {
      groups_.decided(packet.rest());
      continue;
    }
    if (packet.verb() == "pushed") {
      pushes_.answered(packet.rest());
      continue;
    }
    const bool was_open = hal_.isOpen();
    try {
      hal_.handle(packet);
    } catch (const link::SegmentError& e) {
      log_.error(e.what());
      hal_.child().kill("it gave no state away");
      return;
    }
    if (!was_open && hal_.isOpen()) {
      log_.info("The HAL " + config_.hal.type + " cycles.");
      hosts_.spawnAll();
      replies_.announceChange();
    }
  }
}

bool HalSupervisor::ended(const std::string& how, bool serving) {
  receive();
  const bool opened = hal_.isOpen();
  const std::string sentence = hal_.failure().empty() ? "The HAL " + how + "." : hal_.failure();
  hal_.ended(link::now());
  stops_.forget();
  pushes_.halEnded();
  board_.edit().hal_pid = 0;
  log_.error(sentence);
  hosts_.killAll();
  if (!serving && !opened) {
    return false;
  }
  if (hal_.respawns().isGivenUp()) {
    log_.error("The HAL died again and again: robotui-rt gives up. What it said last is above.");
    return false;
  }
  return true;
}

void HalSupervisor::respawn(std::int64_t now_ns) {
  if (!hal_.child().isAlive() && now_ns >= hal_.respawns().startAt()) {
    spawn();
    board_.edit().hal_respawns += 1;
  }
}

}  // namespace robotui::rt::supervisor
