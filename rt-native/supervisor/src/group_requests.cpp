#include "robotui/rt/supervisor/group_requests.h"

#include <algorithm>
#include <numeric>

#include "quoted.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {
namespace {

using link::GroupRefusal;
using link::PluginState;

constexpr const char* kNothing = "Nothing was switched: ";
constexpr const char* kNoHal = "The HAL is not there now: it is being started again.";
constexpr std::int64_t kUntilTheSwitch = 60 * link::kMillisecond;  // hosts look for messages every 5 ms
constexpr std::int64_t kPatience = 2 * link::kSecond;              // for plugins that are not ready then
constexpr std::uint64_t kLongestCommonPeriod = 1000;               // cycles
constexpr std::size_t kMostDeferred = 256;

bool contains(const std::vector<std::uint32_t>& plugins, std::uint32_t plugin) {
  return std::find(plugins.begin(), plugins.end(), plugin) != plugins.end();
}

}  // namespace

std::optional<PluginGroup> GroupRequests::groupOf(std::uint64_t client, std::string_view words) {
  PluginGroup group;
  while (!words.empty()) {
    const auto [name, rest] = link::splitWord(words);
    const auto [wanted, behind] = link::splitWord(rest);
    const auto plugin = registry_.find(name);
    std::string wrong;
    if (!plugin)
      wrong = registry_.unknown(name);
    else if (wanted != "1" && wanted != "0")
      wrong = "switch needs 1 or 0 behind each plugin, not " + quoted(wanted) + " behind " + std::string(name) + ".";
    else if (contains(group.start, *plugin) || contains(group.stop, *plugin))
      wrong = std::string(name) + " is there twice.";
    if (!wrong.empty()) {
      replies_.answer(client, kNothing + wrong);
      return std::nullopt;
    }
    (wanted == "1" ? group.start : group.stop).push_back(*plugin);
    words = behind;
  }
  return group;
}

void GroupRequests::switchPlugins(std::uint64_t client, std::string_view words) {
  if (auto group = groupOf(client, words)) begin(client, std::move(*group));
}

void GroupRequests::switchGroup(std::uint64_t client, std::string_view name) {
  const auto found = std::find_if(config_.switch_groups.begin(), config_.switch_groups.end(),
                                  [&](const config::SwitchGroup& group) { return group.name == name; });
  if (found == config_.switch_groups.end()) {
    replies_.answer(client, "There is no group " + quoted(name) +
                                " in switch_groups of the configuration. There are: " +
                                link::listed(config_.switch_groups, &config::SwitchGroup::name, "none") + ".");
    return;
  }
  PluginGroup group;
  for (const std::string& plugin : found->start) group.start.push_back(registry_.find(plugin).value());
  for (const std::string& plugin : found->stop) group.stop.push_back(registry_.find(plugin).value());
  begin(client, std::move(group));
}

void GroupRequests::list(std::uint64_t client) {
  std::string text;
  for (const config::SwitchGroup& group : config_.switch_groups)
    text +=
        (text.empty() ? "" : "\n") + group.name + "\t" + link::listed(group.start) + "\t" + link::listed(group.stop);
  replies_.reply(client, "ok " + text);
}

void GroupRequests::leaveOutWhatIsSo(PluginGroup& plugins) const {
  std::erase_if(plugins.start, [&](std::uint32_t plugin) { return registry_.state(plugin) == PluginState::kRunning; });
  std::erase_if(plugins.stop, [&](std::uint32_t plugin) {
    return !registry_.isActive(plugin) || registry_.state(plugin) == PluginState::kStopping;
  });
}

void GroupRequests::begin(std::uint64_t client, PluginGroup plugins) {
  std::string why = group_ ? "Another group of plugins is just being switched: ask again." : objection(plugins);
  leaveOutWhatIsSo(plugins);
  if (why.empty() && plugins.start.empty() && plugins.stop.empty()) {
    replies_.reply(client, "ok Nothing is to be done: all of it is so.");
    return;
  }
  if (why.empty() && !hal_.isOpen()) why = kNoHal;
  if (!why.empty()) {
    replies_.answer(client, kNothing + why);
    return;
  }
  const link::GroupOrder order = orderOf(plugins);
  arm(order, plugins);
  group_ = Group{order.group, client, std::move(plugins), {}};
}

std::string GroupRequests::objectionToState(std::uint32_t plugin) const {
  const std::string& name = registry_.name(plugin);
  if (registry_.isIo(plugin)) return name + " is an IO plugin, which is not real time: switch it by itself.";
  return registry_.state(plugin) == PluginState::kStarting ? name + " is just being started: ask again." : "";
}

std::string GroupRequests::objection(const PluginGroup& plugins) const {
  for (const auto* list : {&plugins.start, &plugins.stop}) {
    for (const std::uint32_t plugin : *list) {
      if (std::string why = objectionToState(plugin); !why.empty()) return why;
    }
  }
  for (const std::uint32_t plugin : plugins.start) {
    if (registry_.state(plugin) == PluginState::kRunning) continue;
    std::string why = registry_.hasJoints(plugin) ? stops_.objection() : std::string();
    if (why.empty()) why = registry_.objection(plugin, plugins);
    if (!why.empty()) return why;
  }
  return {};
}

std::uint64_t GroupRequests::everyOf(std::uint32_t plugin) const {
  const config::PluginPlan& planned = plan_.plugins[plugin];
  const std::int64_t own = std::chrono::nanoseconds(plan_.hosts[planned.host].threads[planned.thread].period).count();
  const std::int64_t hal = std::max<std::int64_t>(1, hal_.period());
  return static_cast<std::uint64_t>(std::max<std::int64_t>(1, (own + hal / 2) / hal));
}

// A cycle in which all threads are due; where that is rare, the slowest one.
std::uint64_t GroupRequests::commonPeriod(const PluginGroup& plugins) const {
  std::uint64_t common = 1;
  std::uint64_t slowest = 1;
  for (const auto* list : {&plugins.start, &plugins.stop}) {
    for (const std::uint32_t plugin : *list) {
      common = std::min(std::lcm(common, everyOf(plugin)), 2 * kLongestCommonPeriod);
      slowest = std::max(slowest, everyOf(plugin));
    }
  }
  return common <= kLongestCommonPeriod ? common : slowest;
}

link::GroupOrder GroupRequests::orderOf(const PluginGroup& plugins) const {
  const auto cycles = [&](std::int64_t ns) {
    return static_cast<std::uint64_t>(ns / std::max<std::int64_t>(1, hal_.period()));
  };
  link::GroupOrder order;
  order.group = next_;
  order.every = commonPeriod(plugins);
  const std::uint64_t least = hal_.cycle() + cycles(kUntilTheSwitch) + 2 * order.every;
  order.cycle = (least / order.every + 1) * order.every;
  order.until = order.cycle + cycles(kPatience) + order.every;
  for (const std::uint32_t plugin : plugins.stop) {
    order.stop.set(plugin);
    for (const std::uint32_t joint : registry_.jointsOf(plugin)) {
      if (board_.owner(joint) != plugin) continue;
      order.joints.set(joint);
      order.owners.at(joint) = link::kNobody;
    }
  }
  for (const std::uint32_t plugin : plugins.start) {
    order.start.set(plugin);
    for (const std::uint32_t joint : registry_.jointsOf(plugin)) {
      order.joints.set(joint);
      order.owners.at(joint) = static_cast<std::uint16_t>(plugin);
    }
  }
  return order;
}

void GroupRequests::arm(const link::GroupOrder& order, const PluginGroup& plugins) {
  ++next_;
  const auto tell = [&](std::uint32_t plugin, const char* wanted) {
    tellHost(plugin, "arm " + std::to_string(order.group) + " " + std::to_string(order.cycle - everyOf(plugin)) + " " +
                         registry_.name(plugin) + " " + wanted);
  };
  for (const std::uint32_t plugin : plugins.start) {
    registry_.preparing(plugin);
    tell(plugin, "1");
  }
  for (const std::uint32_t plugin : plugins.stop) tell(plugin, "0");
  board_.publish();
  hal_.child().socket().send(link::textOf(order));
}

void GroupRequests::tellHost(std::uint32_t plugin, const std::string& words) {
  hosts_[registry_.host(plugin)].child().socket().send(words);
}

// Only the HAL knows whether it is too late for that: it answers in any case.
void GroupRequests::giveUp(const std::string& why) {
  if (!group_ || !group_->why.empty()) return;
  group_->why = why;
  hal_.child().socket().send("cancel " + std::to_string(group_->number));
}

// A plugin that is to be stopped and stops by itself is what was wanted, unless its process died.
std::string GroupRequests::lost() const {
  for (const std::uint32_t plugin : group_->plugins.start) {
    const PluginState now = registry_.state(plugin);
    if (now != PluginState::kStarting && now != PluginState::kRunning)
      return registry_.name(plugin) + " is " + registry_.describe(plugin);
  }
  for (const std::uint32_t plugin : group_->plugins.stop) {
    const PluginState now = registry_.state(plugin);
    if (now == PluginState::kAbsent || now == PluginState::kFailed)
      return registry_.name(plugin) + " is " + registry_.describe(plugin);
  }
  return {};
}

void GroupRequests::turn() {
  if (!group_) return;
  if (!hal_.isOpen()) {
    const Group group = *group_;
    group_.reset();
    undone(group, "the HAL is gone.");
  } else if (const std::string why = lost(); !why.empty()) {
    giveUp(why);
  }
}

void GroupRequests::decided(std::string_view words) {
  const auto outcome = link::groupOutcomeOf(words);
  if (!outcome || !group_ || outcome->group != group_->number) return;
  const Group group = *group_;
  group_.reset();
  if (outcome->refusal == GroupRefusal::kNone)
    done(group, outcome->cycle);
  else
    undone(group, reasonOf(group, *outcome));
}

std::string GroupRequests::reasonOf(const Group& group, const link::GroupOutcome& outcome) const {
  if (!group.why.empty()) return group.why;
  if (outcome.refusal == GroupRefusal::kSafe) {
    const std::string stopped = stops_.objection();
    return stopped.empty() ? "the hardware does not answer, and all joints are in their safe state." : stopped;
  }
  std::string names;
  for (std::uint32_t plugin = 0; plugin < registry_.size(); ++plugin) {
    if (outcome.lacking.test(plugin)) names += (names.empty() ? "" : ", ") + registry_.name(plugin);
  }
  return names + " did not get ready in time: its thread does not run, or is late again and again.";
}

// Joints first to those that have them now: nobody may see them without an owner.
void GroupRequests::done(const Group& group, std::uint64_t cycle) {
  std::string text = "In cycle " + std::to_string(cycle) + ":";
  std::string lost;
  for (const std::uint32_t plugin : group.plugins.start) registry_.handOver(plugin);
  for (const std::uint32_t plugin : group.plugins.stop) {
    registry_.left(plugin);
    text += " " + registry_.name(plugin) + " is stopped,";
  }
  for (const std::uint32_t plugin : group.plugins.start) {
    const PluginState now = registry_.state(plugin);
    if (now == PluginState::kStarting || now == PluginState::kRunning)
      registry_.started(plugin);
    else
      lost += " Since then " + registry_.name(plugin) + " is " + registry_.describe(plugin);
    text += " " + registry_.name(plugin) + " runs,";
  }
  text.back() = '.';
  log_.info(text + lost);
  replies_.reply(group.client, (lost.empty() ? "ok " : "error ") + text + lost);
}

void GroupRequests::undone(const Group& group, const std::string& why) {
  for (const std::uint32_t plugin : group.plugins.start) {
    if (registry_.state(plugin) == PluginState::kStarting) registry_.stopping(plugin);
    tellHost(plugin, "disarm " + registry_.name(plugin));
  }
  for (const std::uint32_t plugin : group.plugins.stop) tellHost(plugin, "disarm " + registry_.name(plugin));
  log_.warn(kNothing + why);
  replies_.answer(group.client, kNothing + why);
}

bool GroupRequests::defers(std::uint64_t client, std::string_view words, std::uint32_t plugin, bool start) {
  if (!group_ || deferred_.size() >= kMostDeferred) return false;
  const bool is_member = contains(group_->plugins.start, plugin) || contains(group_->plugins.stop, plugin);
  if (!start && !is_member) return false;
  if (!start) giveUp(registry_.name(plugin) + " was told to stop meanwhile.");
  deferred_.push_back({client, std::string(words)});
  return true;
}

std::vector<GroupRequests::Deferred> GroupRequests::takeDeferred() {
  return group_ ? std::vector<Deferred>() : std::exchange(deferred_, {});
}

}  // namespace robotui::rt::supervisor
