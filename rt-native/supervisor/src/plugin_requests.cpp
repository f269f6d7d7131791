#include "robotui/rt/supervisor/plugin_requests.h"

#include "quoted.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/words.h"
#include "robotui/rt/supervisor/task_words.h"
#include "robotui/rt/supervisor/trajectory_words.h"

namespace robotui::rt::supervisor {
namespace {

using link::PluginState;

constexpr std::int64_t kPatience = 2 * link::kSecond;
constexpr std::int64_t kReloadPatience = 65 * link::kSecond;  // a plugin has a minute

}  // namespace

void PluginRequests::switchPlugin(std::uint64_t client, std::string_view words) {
  const auto [name, behind] = link::splitWord(words);
  const auto [wanted, more] = link::splitWord(behind);
  const auto plugin = registry_.find(name);
  if (!more.empty()) {
    groups_.switchPlugins(client, words);
  } else if (!plugin) {
    replies_.answer(client, registry_.unknown(name));
  } else if (wanted != "1" && wanted != "0") {
    replies_.answer(client, "switch needs 1 or 0 behind the plugin, not " + quoted(wanted) + ".");
  } else if (groups_.defers(client, words, *plugin, wanted == "1")) {
    return;
  } else if (wanted == "1") {
    start(client, *plugin);
  } else {
    stop(client, *plugin);
  }
}

// What has no joints may look on, also while an emergency stop is pressed.
std::string PluginRequests::objection(std::uint32_t plugin) const {
  const std::string stopped = registry_.hasJoints(plugin) ? stops_.objection() : std::string();
  return stopped.empty() ? registry_.objection(plugin) : stopped;
}

void PluginRequests::start(std::uint64_t client, std::uint32_t plugin) {
  if (registry_.state(plugin) == PluginState::kRunning) {
    replies_.answer(client, {});
    return;
  }
  if (registry_.state(plugin) != PluginState::kStarting) {
    const std::string why = objection(plugin);
    if (!why.empty()) {
      replies_.answer(client, why);
      return;
    }
    registry_.starting(plugin);
    board_.publish();
    hostOf(plugin).child().socket().send("start " + registry_.name(plugin));
  }
  pending_.add(Awaited::kStart, plugin, client, link::now() + kPatience);
}

void PluginRequests::stop(std::uint64_t client, std::uint32_t plugin) {
  if (!registry_.isActive(plugin)) {
    replies_.answer(client, {});
    return;
  }
  if (registry_.state(plugin) != PluginState::kStopping) {
    registry_.stopping(plugin);
    hostOf(plugin).child().socket().send("stop " + registry_.name(plugin));
  }
  pending_.add(Awaited::kStop, plugin, client, link::now() + kPatience);
}

void PluginRequests::reload(std::uint64_t client, std::string_view words) {
  const auto plugin = registry_.find(words);
  if (!plugin) {
    replies_.answer(client, registry_.unknown(words));
    return;
  }
  if (registry_.isActive(*plugin) && !registry_.isIo(*plugin)) {
    replies_.answer(client, registry_.name(*plugin) + " runs: stop it before it is reloaded.");
    return;
  }
  HostProcess& host = hostOf(*plugin);
  pending_.add(Awaited::kReload, *plugin, client, link::now() + kReloadPatience);
  if (host.child().isAlive()) {
    host.child().socket().send("reload " + registry_.name(*plugin));
  } else {
    host.resetDeaths();  // it is started in the next turn, or when the HAL is there again
  }
}

void PluginRequests::command(std::uint64_t client, std::string_view words) {
  const auto [name, order] = link::splitWord(words);
  const auto plugin = registry_.find(name);
  if (!plugin) {
    replies_.answer(client, registry_.unknown(name));
    return;
  }
  HostProcess& host = hostOf(*plugin);
  const PluginState state = registry_.state(*plugin);
  if (!host.child().isAlive() || state == PluginState::kAbsent || state == PluginState::kFailed) {
    replies_.answer(client, registry_.name(*plugin) + " is not there to be told something: it is " +
                                registry_.describe(*plugin) + ".");
    return;
  }
  const std::uint32_t id = next_command_++;
  pending_.add(Awaited::kCommand, *plugin, client, link::now() + kPatience, id);
  host.child().socket().send("command " + std::to_string(id) + " " + registry_.name(*plugin) + " " +
                             std::string(order));
}

void PluginRequests::status(std::uint64_t client, std::string_view words) {
  const auto plugin = registry_.find(words);
  replies_.reply(client, plugin ? "ok " + registry_.describe(*plugin) : "error " + registry_.unknown(words));
}

void PluginRequests::trajectory(std::uint64_t client, std::string_view words) {
  const auto plugin = registry_.find(words);
  if (!plugin) {
    replies_.answer(client, registry_.unknown(words));
    return;
  }
  const auto report = trajectoryReport(*hostOf(*plugin).channels().get(), registry_.name(*plugin));
  if (report)
    replies_.reply(client, "ok " + trajectoryWords(*report, board_.data().joints));
  else
    replies_.answer(client, registry_.name(*plugin) + " says nothing of trajectories.");
}

void PluginRequests::tasks(std::uint64_t client, std::string_view words) {
  const auto plugin = registry_.find(words);
  if (!plugin) {
    replies_.reply(client, "error " + registry_.unknown(words));
    return;
  }
  if (const auto report = taskReport(*hostOf(*plugin).channels().get(), registry_.name(*plugin)))
    replies_.reply(client, "ok " + taskWords(*report));
  else
    replies_.answer(client, registry_.name(*plugin) + " says nothing of tasks.");
}

}  // namespace robotui::rt::supervisor
