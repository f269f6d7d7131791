#include "robotui/rt/supervisor/host_supervisor.h"

#include <algorithm>

#include "numbers.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {
namespace {

// Of the robot's cycles. Ordinary threads may have to wait for others for long.
constexpr std::int64_t kRealTimePatience = 300 * link::kMillisecond;
constexpr std::int64_t kOrdinaryPatience = 3 * link::kSecond;

}  // namespace

HostSupervisor::HostSupervisor(const Options& options, const config::Plan& plan, HostMemory memory,
                               PluginEvents& events, ClientReplies& replies, LogFile& log)
    : options_(options), plan_(plan), memory_(memory), events_(events), replies_(replies), log_(log) {
  for (std::uint32_t i = 0; i < plan.hosts.size(); ++i) {
    hosts_.push_back(std::make_unique<HostProcess>(i, plan.hosts[i]));
  }
}

void HostSupervisor::spawnAll() {
  spawned_ = true;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (!hosts_[i]->child().isAlive() && !hosts_[i]->isGivenUp()) {
      spawn(i);
    }
  }
}

void HostSupervisor::spawn(std::uint32_t index) {
  HostProcess& host = *hosts_[index];
  std::vector<link::Descriptor> common;
  common.push_back(memory_.hal.state().shareReadOnly());
  common.push_back(memory_.board.share());
  common.push_back(memory_.master.share());
  std::vector<link::Descriptor> channels = shareChannels();
  if (memory_.ros.isWanted()) {
    channels.push_back(memory_.ros.shareChannels());
  }
  memory_.board.publish();
  host.spawn(childArguments(options_), numbersOf(common), numbersOf(channels));
  auto& entry = memory_.board.edit().host[index];
  entry.pid = host.child().pid();
  link::assign(entry.error, "");
  const link::Descriptor segment = host.segment().shareReadOnly();
  const int fd = segment.get();
  memory_.hal.child().socket().send("host " + std::to_string(index), {&fd, 1});
  replies_.announceChange();
}

void HostSupervisor::turn() {
  for (std::uint32_t i = 0; i < size(); ++i) {
    receive(i);
    if (const auto how = hosts_[i]->child().end()) {
      receive(i);
      ended(i, *how);
    }
  }
}

void HostSupervisor::receive(std::uint32_t host) {
  link::Packet packet;
  link::Socket& socket = hosts_[host]->child().socket();
  while (socket.isOpen() && socket.receive(packet, std::chrono::milliseconds(0)) == link::Received::kPacket) {
    handle(host, packet);
  }
}

void HostSupervisor::handle(std::uint32_t index, const link::Packet& packet) {
  HostProcess& host = *hosts_[index];
  log_.detail("host " + host.name() + " says: " + packet.text);
  host.handle(packet, link::now());
  if (packet.verb() == "log") {
    log_.relay({}, packet.rest());
  } else if (packet.verb() == "ready") {
    log_.info("The host " + host.name() + " is ready.");
  } else {
    events_.handle(index, packet, host.child().socket());
  }
}

void HostSupervisor::ended(std::uint32_t index, const std::string& how) {
  HostProcess& host = *hosts_[index];
  const auto death = host.ended(how, link::now(), [&](std::uint32_t plugin) { return events_.nameOf(plugin); });
  log_.error(death.sentence);
  events_.hostDied(index, death.sentence, death.at_work);
  auto& entry = memory_.board.edit().host[index];
  entry.pid = 0;
  link::assign(entry.error, death.sentence);
  if (host.isGivenUp()) {
    const std::string sentence =
        host.isBroken()
            ? death.sentence
            : death.sentence +
                  " It died again and again and is not started any more; reload a plugin of it to try again.";
    link::assign(entry.error, sentence);
    log_.error("The host " + host.name() + " is not started any more.");
    events_.hostGivenUp(index, sentence);
  }
  replies_.announceChange();  // its memory may be another one now
}

void HostSupervisor::respawn(std::int64_t now_ns) {
  for (std::uint32_t i = 0; i < size() && memory_.hal.isOpen(); ++i) {
    HostProcess& host = *hosts_[i];
    if (!host.child().isAlive() && !host.isGivenUp() && now_ns >= host.respawns().startAt()) {
      spawn(i);
      memory_.board.edit().host[i].respawns += 1;
    }
  }
}

void HostSupervisor::watch(std::int64_t now_ns) {
  for (std::uint32_t i = 0; i < size(); ++i) {
    const bool is_real_time = memory_.board.data().real_time != 0 && plan_.hosts[i].kind == config::HostKind::kRealTime;
    hosts_[i]->watch(memory_.hal.cycle(), memory_.hal.period(), is_real_time ? kRealTimePatience : kOrdinaryPatience,
                     now_ns);
  }
}

void HostSupervisor::killAll() {
  for (const auto& host : hosts_) {
    host->child().kill("the HAL was gone");
  }
}

bool HostSupervisor::areSettled() const {
  return spawned_ && std::all_of(hosts_.begin(), hosts_.end(),
                                 [](const auto& host) { return host->isReady() || host->isGivenUp(); });
}

std::vector<link::Descriptor> HostSupervisor::shareSegments() const {
  std::vector<link::Descriptor> shared;
  for (const auto& host : hosts_) {
    shared.push_back(host->segment().shareReadOnly());
  }
  return shared;
}

std::vector<link::Descriptor> HostSupervisor::shareChannels() const {
  std::vector<link::Descriptor> shared;
  for (const auto& host : hosts_) {
    shared.push_back(host->channels().shareReadOnly());
  }
  return shared;
}

std::vector<Child*> HostSupervisor::running() {
  std::vector<Child*> children;
  for (const auto& host : hosts_) {
    if (host->child().isAlive()) {
      children.push_back(&host->child());
    }
  }
  return children;
}

}  // namespace robotui::rt::supervisor
