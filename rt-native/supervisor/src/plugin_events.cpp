#include "robotui/rt/supervisor/plugin_events.h"

#include <cstdlib>

#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {

using link::PluginState;

void PluginEvents::handle(std::uint32_t host, const link::Packet& packet, const link::Socket& socket) {
  const std::string_view verb = packet.verb();
  const auto [first, rest] = link::splitWord(packet.rest());
  if (verb == "answer") {
    commandAnswered(host, first, rest == "ok");
    return;
  }
  const auto plugin = registry_.find(first);
  if (!plugin || registry_.host(*plugin) != host) {
    return;
  }
  if (verb == "loaded") {
    loaded(*plugin, rest, socket);
  } else if (verb == "started" && registry_.state(*plugin) == PluginState::kStarting) {
    started(*plugin);
  } else if (verb == "stopped" && registry_.isActive(*plugin)) {
    stopped(*plugin);
  } else if (verb == "failed") {
    failed(*plugin, rest);
  } else if (verb == "status") {
    registry_.setStatus(*plugin, rest);
  }
}

void PluginEvents::commandAnswered(std::uint32_t host, std::string_view id, bool understood) {
  const auto number = static_cast<std::uint32_t>(std::strtoul(std::string(id).c_str(), nullptr, 10));
  for (const std::uint32_t plugin : registry_.ofHost(host)) {
    pending_.settle(Awaited::kCommand, plugin,
                    understood ? "ok" : "error " + registry_.name(plugin) + " does not understand this.", number);
  }
}

// An IO plugin is started as soon as it is loaded.
void PluginEvents::loaded(std::uint32_t plugin, std::string_view role_and_joints, const link::Socket& socket) {
  const std::string& name = registry_.name(plugin);
  const auto [word, joints] = link::splitWord(role_and_joints);
  const auto role = link::pluginRole(word);
  if (!role) {
    failed(plugin, "The host of " + name + " says that its role is '" + std::string(word) +
                       "', which this robotui-rt does not know.");
    return;
  }
  registry_.loaded(plugin, *role, joints);
  pending_.settle(Awaited::kReload, plugin, "ok");
  if (registry_.isIo(plugin)) {
    registry_.starting(plugin);
    socket.send("start " + name);
  }
}

void PluginEvents::started(std::uint32_t plugin) {
  log_.info(registry_.name(plugin) + " runs.");
  registry_.started(plugin);
  pending_.settle(Awaited::kStart, plugin, "ok");
}

void PluginEvents::stopped(std::uint32_t plugin) {
  log_.info(registry_.name(plugin) + " is stopped.");
  registry_.stopped(plugin);
  pending_.settle(Awaited::kStop, plugin, "ok");
}

void PluginEvents::failed(std::uint32_t plugin, std::string_view sentence) {
  log_.error(sentence);
  registry_.failed(plugin, sentence);
  pending_.settleAll(plugin, "error " + std::string(sentence));
}

void PluginEvents::hostDied(std::uint32_t host, const std::string& sentence, const std::set<std::uint32_t>& at_work) {
  for (const std::uint32_t plugin : registry_.ofHost(host)) {
    const bool concerned = registry_.isActive(plugin) || at_work.count(plugin) != 0;
    registry_.lost(plugin, concerned ? sentence : std::string());
    pending_.settleAll(plugin, "error " + sentence);
  }
}

void PluginEvents::hostGivenUp(std::uint32_t host, const std::string& sentence) {
  for (const std::uint32_t plugin : registry_.ofHost(host)) {
    registry_.failed(plugin, sentence);
  }
}

}  // namespace robotui::rt::supervisor
