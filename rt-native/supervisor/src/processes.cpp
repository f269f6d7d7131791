#include "numbers.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/supervisor/supervisor.h"

namespace robotui::rt::supervisor {
namespace {

using link::PluginState;

// Of the robot's cycles. Ordinary threads may have to wait for others for long.
constexpr std::int64_t kRealTimePatience = 300 * link::kMillisecond;
constexpr std::int64_t kOrdinaryPatience = 3 * link::kSecond;

// "a b c": the first word, and the rest behind the space.
std::pair<std::string_view, std::string_view> split(std::string_view words) {
  const std::size_t space = words.find(' ');
  return space == std::string_view::npos ? std::pair{words, std::string_view()} : std::pair{words.substr(0, space), words.substr(space + 1)};
}

}  // namespace

// ---- the HAL ----------------------------------------------------------------------------------------------------------

void Supervisor::spawnHal() {
  std::vector<link::Descriptor> shared;
  shared.push_back(board_.share());
  for (const auto& host : hosts_) {
    shared.push_back(host->segment().shareReadOnly());
  }
  const std::vector<int> given = numbersOf(shared);
  std::vector<std::string> arguments = childArguments(options_);
  if (options_.allow_non_rt) {
    arguments.emplace_back("--allow-non-rt");
  }
  if (options_.nrt) {
    arguments.emplace_back("--nrt");
  }
  hal_.spawn(arguments, given);
  board_.edit().hal_pid = hal_.child().pid();
}

void Supervisor::hearHal() {
  link::Packet packet;
  while (hal_.child().socket().isOpen() && hal_.child().socket().receive(packet, std::chrono::milliseconds(0)) == link::Received::kPacket) {
    const bool was_open = hal_.isOpen();
    if (packet.verb() == "log") {
      log("hal", packet.rest());
      continue;
    }
    try {
      hal_.heard(packet);
    } catch (const link::SegmentError& e) {
      journal_.error(e.what());
      hal_.child().kill("it gave no state away");
      return;
    }
    if (!was_open && hal_.isOpen()) {
      journal_.info("The HAL " + config_.hal.type + " cycles.");
      spawnHosts();
      changed();
    }
  }
}

void Supervisor::reapHal() {
  const auto how = hal_.child().end();
  if (!how) {
    return;
  }
  hearHal();
  const bool opened = hal_.isOpen();
  const std::string sentence = hal_.failure().empty() ? "The HAL " + *how + "." : hal_.failure();
  hal_.died(link::now());
  board_.edit().hal_pid = 0;
  journal_.error(sentence);
  for (const auto& host : hosts_) {
    host->child().kill("the HAL was gone");
  }
  if (!serving_ && !opened) {
    exit_code_ = 1;
    ending_ = true;
  } else if (hal_.respawns().isGivenUp()) {
    journal_.error("The HAL died again and again: robotui-rt gives up. What it said last is above.");
    exit_code_ = 1;
    ending_ = true;
  }
}

// ---- hosts ------------------------------------------------------------------------------------------------------------

void Supervisor::spawnHosts() {
  for (std::uint32_t i = 0; i < hosts_.size(); ++i) {
    if (!hosts_[i]->child().isAlive() && !hosts_[i]->isLeftAlone()) {
      spawnHost(i);
    }
  }
  serving_ = serving_ || hosts_.empty();
}

void Supervisor::spawnHost(std::uint32_t index) {
  HostKeeper& host = *hosts_[index];
  std::vector<link::Descriptor> shared;
  shared.push_back(hal_.state().shareReadOnly());
  shared.push_back(board_.share());
  shared.push_back(master_.share());
  const std::size_t common = shared.size();
  for (const auto& each : hosts_) {
    shared.push_back(each->channels().shareReadOnly());
  }
  if (ros_.isWanted()) {
    shared.push_back(ros_.shareChannels());
  }
  const std::vector<int> given = numbersOf(shared);
  const auto border = given.begin() + static_cast<std::ptrdiff_t>(common);
  board_.publish();
  host.spawn(childArguments(options_), {given.begin(), border}, {border, given.end()});
  auto& entry = board_.edit().host[index];
  entry.pid = host.child().pid();
  link::assign(entry.error, "");
  const link::Descriptor segment = host.segment().shareReadOnly();
  const int fd = segment.get();
  hal_.child().socket().send("host " + std::to_string(index), {&fd, 1});
  changed();
}

void Supervisor::hearHost(std::uint32_t host) {
  link::Packet packet;
  link::Socket& socket = hosts_[host]->child().socket();
  while (socket.isOpen() && socket.receive(packet, std::chrono::milliseconds(0)) == link::Received::kPacket) {
    hostSaid(host, packet);
  }
}

void Supervisor::hostSaid(std::uint32_t host, const link::Packet& packet) {
  journal_.detail("host " + hosts_[host]->name() + " says: " + packet.text);
  hosts_[host]->heard(packet, link::now());
  const std::string_view verb = packet.verb();
  if (verb == "log") {
    log({}, packet.rest());
    return;
  }
  if (verb == "ready") {
    serving_ = serving_ || areHostsSettled();
    journal_.info("The host " + hosts_[host]->name() + " is ready.");
    return;
  }
  const auto [first, rest] = split(packet.rest());
  if (verb == "answer") {
    const auto id = static_cast<std::uint32_t>(std::strtoul(std::string(first).c_str(), nullptr, 10));
    const bool ok = rest == "ok";
    for (const std::uint32_t plugin : roster_.ofHost(host)) {
      pending_.settle(Awaited::kCommand, plugin, ok ? "ok" : "error " + roster_.name(plugin) + " does not understand this.", id);
    }
    return;
  }
  const auto plugin = roster_.find(first);
  if (plugin && roster_.host(*plugin) == host) {
    pluginSaid(*plugin, verb, rest);
  }
}

void Supervisor::pluginSaid(std::uint32_t plugin, std::string_view verb, std::string_view rest) {
  const std::string& name = roster_.name(plugin);
  if (verb == "loaded") {
    roster_.loaded(plugin, rest);
    pending_.settle(Awaited::kReload, plugin, "ok");
    if (roster_.isIo(plugin)) {
      roster_.starting(plugin);
      hosts_[roster_.host(plugin)]->child().socket().send("start " + name);
    }
  } else if (verb == "started" && roster_.state(plugin) == PluginState::kStarting) {
    journal_.info(name + " runs.");
    roster_.started(plugin);
    pending_.settle(Awaited::kStart, plugin, "ok");
  } else if (verb == "stopped" && roster_.isActive(plugin)) {
    journal_.info(name + " is stopped.");
    roster_.stopped(plugin);
    pending_.settle(Awaited::kStop, plugin, "ok");
  } else if (verb == "failed") {
    journal_.error(std::string(rest));
    roster_.failed(plugin, rest);
    pending_.settleAll(plugin, "error " + std::string(rest));
  } else if (verb == "status") {
    roster_.setStatus(plugin, rest);
  }
}

void Supervisor::log(const std::string& whose, std::string_view words) {
  const auto [level, line] = split(words);
  const bool known = level == "info" || level == "warn" || level == "error";
  journal_.write(known ? level : "info", (whose.empty() ? "" : whose + ": ") + std::string(line));
}

void Supervisor::reapHost(std::uint32_t host) {
  if (const auto how = hosts_[host]->child().end()) {
    hearHost(host);
    hostDied(host, *how);
  }
}

void Supervisor::hostDied(std::uint32_t index, const std::string& how) {
  HostKeeper& host = *hosts_[index];
  const auto obituary = host.died(how, link::now(), [&](std::uint32_t p) { return p < roster_.size() ? roster_.name(p) : "?"; });
  journal_.error(obituary.sentence);
  for (const std::uint32_t plugin : roster_.ofHost(index)) {
    const bool concerned = roster_.isActive(plugin) || obituary.culprits.count(plugin) != 0;
    roster_.lost(plugin, concerned ? obituary.sentence : std::string());
    pending_.settleAll(plugin, "error " + obituary.sentence);
  }
  auto& entry = board_.edit().host[index];
  entry.pid = 0;
  link::assign(entry.error, obituary.sentence);
  if (host.isLeftAlone()) {
    const std::string sentence = host.isBroken() ? obituary.sentence : obituary.sentence + " It died again and again and is not started any more; reload a plugin of it to try again.";
    link::assign(entry.error, sentence);
    journal_.error("The host " + host.name() + " is not started any more.");
    for (const std::uint32_t plugin : roster_.ofHost(index)) {
      roster_.failed(plugin, sentence);
    }
    serving_ = serving_ || areHostsSettled();
  }
}

bool Supervisor::areHostsSettled() const {
  for (const auto& host : hosts_) {
    if (!host->isReady() && !host->isLeftAlone()) {
      return false;
    }
  }
  return true;
}

void Supervisor::respawn(std::int64_t now) {
  if (ending_) {
    return;
  }
  if (!hal_.child().isAlive() && now >= hal_.respawns().startAt()) {
    spawnHal();
    board_.edit().hal_respawns += 1;
  }
  for (std::uint32_t i = 0; i < hosts_.size() && hal_.isOpen(); ++i) {
    HostKeeper& host = *hosts_[i];
    if (!host.child().isAlive() && !host.isLeftAlone() && now >= host.respawns().startAt()) {
      spawnHost(i);
      board_.edit().host[i].respawns += 1;
    }
  }
}

void Supervisor::watch(std::int64_t now) {
  hal_.watch(now);
  for (std::uint32_t i = 0; i < hosts_.size(); ++i) {
    const bool is_real_time = board_.data().real_time != 0 && plan_.hosts[i].kind == config::HostKind::kRealTime;
    hosts_[i]->watch(hal_.cycle(), hal_.period(), is_real_time ? kRealTimePatience : kOrdinaryPatience, now);
  }
}

}  // namespace robotui::rt::supervisor
