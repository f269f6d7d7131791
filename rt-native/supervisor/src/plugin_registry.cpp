#include "robotui/rt/supervisor/plugin_registry.h"

#include <algorithm>

#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {

using link::PluginRole;
using link::PluginState;

std::string_view nameOf(PluginState state) noexcept {
  switch (state) {
    case PluginState::kAbsent: return "absent";
    case PluginState::kLoaded: return "loaded";
    case PluginState::kStopped: return "stopped";
    case PluginState::kStarting: return "starting";
    case PluginState::kRunning: return "running";
    case PluginState::kStopping: return "stopping";
    case PluginState::kFailed: return "failed";
  }
  return "unknown";
}

PluginRegistry::PluginRegistry(const config::RtConfig& config, const config::Plan& plan, BoardPublisher& board)
    : config_(config), plan_(plan), board_(board) {
  for (const config::PluginPlan& planned : plan.plugins) {
    plugins_.push_back({planned.plugin.name, PluginRole::kControl, {}});
  }
}

std::optional<std::uint32_t> PluginRegistry::find(std::string_view name) const {
  const auto found =
      std::find_if(plugins_.begin(), plugins_.end(), [&](const Plugin& plugin) { return plugin.name == name; });
  return found == plugins_.end() ? std::nullopt : std::optional(static_cast<std::uint32_t>(found - plugins_.begin()));
}

PluginState PluginRegistry::state(std::uint32_t plugin) const {
  return static_cast<PluginState>(board_.data().plugin[plugin].state);
}

bool PluginRegistry::isIo(std::uint32_t plugin) const { return board_.data().plugin[plugin].io != 0; }

bool PluginRegistry::isActive(std::uint32_t plugin) const {
  const PluginState now = state(plugin);
  return now == PluginState::kStarting || now == PluginState::kRunning || now == PluginState::kStopping;
}

std::vector<std::uint32_t> PluginRegistry::ofHost(std::uint32_t host) const {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (this->host(i) == host) {
      all.push_back(i);
    }
  }
  return all;
}

std::optional<std::uint32_t> PluginRegistry::masterPlugin() const {
  std::optional<std::uint32_t> found;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (plugins_[i].role == PluginRole::kMaster && (!found || isActive(i))) found = i;
  }
  return found;
}

std::string PluginRegistry::unknown(std::string_view name) const {
  return "There is no plugin '" + std::string(name.substr(0, link::kNameLength)) +
         "'. There are: " + link::listed(plugins_, &Plugin::name, "none") + ".";
}

std::string PluginRegistry::objection(std::uint32_t plugin, const PluginGroup& with) const {
  const std::string& name = plugins_[plugin].name;
  switch (state(plugin)) {
    case PluginState::kAbsent:
    case PluginState::kLoaded: return name + " is not loaded yet: its host starts.";
    case PluginState::kFailed:
      return name +
             " has failed and must be reloaded first: " + std::string(link::view(board_.data().plugin[plugin].error));
    case PluginState::kStopping: return name + " is just being stopped.";
    default: break;
  }
  if (isIo(plugin)) {
    return {};
  }
  std::string why = masterObjection(plugin, with);
  if (why.empty()) why = jointObjection(plugin, with);
  return why.empty() ? groupObjection(plugin, with) : why;
}

// Whether it runs, or will, when the group is switched.
bool PluginRegistry::isBeside(std::uint32_t other, const PluginGroup& with) const {
  const auto is_in = [&](const std::vector<std::uint32_t>& plugins) {
    return std::find(plugins.begin(), plugins.end(), other) != plugins.end();
  };
  return is_in(with.start) || (isActive(other) && !is_in(with.stop));
}

// Two that are started together.
std::string PluginRegistry::groupObjection(std::uint32_t plugin, const PluginGroup& with) const {
  for (const std::uint32_t other : with.start) {
    for (const std::uint32_t joint : plugins_[other].joints) {
      const auto& mine = plugins_[plugin].joints;
      if (other != plugin && std::find(mine.begin(), mine.end(), joint) != mine.end())
        return plugins_[plugin].name + " and " + plugins_[other].name +
               " cannot run together: both command the joint " + config_.robot.joints[joint].name + ".";
    }
  }
  return {};
}

// The master framework commands the whole robot, or the plugins do; observers are beside both.
std::string PluginRegistry::masterObjection(std::uint32_t plugin, const PluginGroup& with) const {
  const Plugin& wanted = plugins_[plugin];
  if (wanted.role == PluginRole::kObserver) {
    return {};
  }
  std::string others;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (i == plugin || !isBeside(i, with) || isIo(i)) {
      continue;
    }
    if (plugins_[i].role == PluginRole::kMaster) {
      return wanted.name + " cannot be started while " + plugins_[i].name +
             " runs: the master framework commands the robot. Stop " + plugins_[i].name + " first.";
    }
    if (plugins_[i].role == PluginRole::kControl) {
      others += (others.empty() ? "" : ", ") + plugins_[i].name;
    }
  }
  if (wanted.role == PluginRole::kMaster && !others.empty()) {
    return wanted.name + " cannot be started while other plugins run (" + others +
           "): the master framework commands the whole robot. Stop them first.";
  }
  return {};
}

std::string PluginRegistry::jointObjection(std::uint32_t plugin, const PluginGroup& with) const {
  for (const std::uint32_t joint : plugins_[plugin].joints) {
    const std::uint16_t owner = board_.owner(joint);
    if (owner != link::kNobody && owner != plugin && owner < size() && isBeside(owner, with)) {
      return plugins_[plugin].name + " cannot be started while " + plugins_[owner].name +
             " runs: both command the joint " + config_.robot.joints[joint].name + ". Stop " + plugins_[owner].name +
             " first.";
    }
  }
  return {};
}

void PluginRegistry::loaded(std::uint32_t plugin, PluginRole role, std::string_view joints) {
  Plugin& mine = plugins_[plugin];
  mine.role = role;
  mine.joints.clear();
  const auto& all = config_.robot.joints;
  link::forEachWord(joints, [&](std::string_view name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& joint) { return joint.name == name; });
    if (found != all.end()) {
      mine.joints.push_back(static_cast<std::uint32_t>(found - all.begin()));
    }
  });
  // Why it was stopped stays to be read, where its host died.
  const bool was_lost = state(plugin) == PluginState::kAbsent;
  set(plugin, PluginState::kStopped,
      was_lost ? std::string(link::view(board_.data().plugin[plugin].error)) : std::string());
}

void PluginRegistry::starting(std::uint32_t plugin) {
  handOver(plugin);
  set(plugin, PluginState::kStarting, {});
}

void PluginRegistry::preparing(std::uint32_t plugin) { set(plugin, PluginState::kStarting, {}); }

void PluginRegistry::handOver(std::uint32_t plugin) {
  for (const std::uint32_t joint : plugins_[plugin].joints) {
    board_.grant(joint, plugin);
  }
}

void PluginRegistry::left(std::uint32_t plugin) {
  if (state(plugin) == PluginState::kRunning)
    stopping(plugin);
  else
    releaseJoints(plugin);
}

void PluginRegistry::started(std::uint32_t plugin) { set(plugin, PluginState::kRunning, {}); }

void PluginRegistry::stopping(std::uint32_t plugin) {
  releaseJoints(plugin);
  set(plugin, PluginState::kStopping, {});
}

void PluginRegistry::fell(std::uint32_t plugin, std::string_view sentence) {
  set(plugin, PluginState::kStopping, sentence);
}

void PluginRegistry::stopped(std::uint32_t plugin) {
  const std::string why(link::view(board_.data().plugin[plugin].error));
  if (why.empty()) releaseJoints(plugin);
  set(plugin, PluginState::kStopped, why);
}

void PluginRegistry::releaseJoints(std::uint32_t plugin) {
  for (const std::uint32_t joint : plugins_[plugin].joints) {
    board_.release(joint, plugin);
  }
}

void PluginRegistry::failed(std::uint32_t plugin, std::string_view sentence) {
  set(plugin, PluginState::kFailed, sentence);
}

void PluginRegistry::lost(std::uint32_t plugin, std::string_view sentence) {
  if (state(plugin) == PluginState::kFailed && sentence.empty()) {
    return;
  }
  board_.edit().plugin[plugin].respawns += 1;
  const std::string before(link::view(board_.data().plugin[plugin].error));
  set(plugin, PluginState::kAbsent, sentence.empty() ? before : sentence);
}

void PluginRegistry::set(std::uint32_t plugin, PluginState state, std::string_view error) {
  auto& entry = board_.edit().plugin[plugin];
  entry.state = static_cast<std::uint32_t>(state);
  link::assign(entry.error, error);
  if (state == PluginState::kAbsent || state == PluginState::kFailed) {
    setStatus(plugin, {});
  }
}

void PluginRegistry::setStatus(std::uint32_t plugin, std::string_view line) {
  link::assign(board_.edit().plugin[plugin].status, line);
}

std::string PluginRegistry::describe(std::uint32_t plugin) const {
  const std::string error(link::view(board_.data().plugin[plugin].error));
  const std::string detail = error.empty() ? std::string(link::view(board_.data().plugin[plugin].status)) : error;
  return std::string(nameOf(state(plugin))) + (detail.empty() ? "" : ": " + detail);
}

}  // namespace robotui::rt::supervisor
