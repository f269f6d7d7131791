#include <algorithm>
#include <set>

#include "blocks.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::config {
namespace {

constexpr const char* kExample = "{start: [Walk, Balance], stop: [Stand]}";

std::vector<std::string> namesOf(const std::vector<PluginConfig>& plugins) {
  std::vector<std::string> names;
  names.reserve(plugins.size());
  for (const PluginConfig& plugin : plugins) names.push_back(plugin.name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Each plugin is there once: it is started or stopped.
std::vector<std::string> readMembers(const Reader& group, std::string_view key, const RtConfig& config,
                                     std::set<std::string>& taken) {
  std::vector<std::string> members;
  const auto list = group.find(key);
  if (!list) return members;
  std::vector<std::string> known = namesOf(config.plugins);
  for (const std::string& name : namesOf(config.nrt_plugins)) known.push_back(name);
  for (const Reader& item : list->items(kExample)) {
    const std::string name = item.text();
    if (contains(namesOf(config.io_plugins), name))
      item.fail("is the IO plugin '" + name + "': these are not real time, and switched by themselves");
    if (!contains(known, name))
      item.fail("is '" + name + "', which is no plugin of this configuration; there are " +
                link::listed(known, {}, "none") + didYouMean(name, known));
    if (!taken.insert(name).second) item.fail("has the plugin '" + name + "' twice");
    members.push_back(name);
  }
  return members;
}

SwitchGroup readGroup(const std::string& name, const Reader& block, const RtConfig& config) {
  mustBeWord(block, name);
  block.knowsOnly({"start", "stop"});
  std::set<std::string> taken;
  SwitchGroup group;
  group.name = name;
  group.start = readMembers(block, "start", config, taken);
  group.stop = readMembers(block, "stop", config, taken);
  if (taken.empty()) block.fail(std::string("names no plugin; write ") + kExample);
  return group;
}

}  // namespace

void readSwitchGroups(const Reader& top, RtConfig& into) {
  const auto block = top.find("switch_groups");
  if (!block) return;
  for (const auto& [name, group] : block->entries()) into.switch_groups.push_back(readGroup(name, group, into));
}

}  // namespace robotui::rt::config
