#include "blocks.h"

#include <algorithm>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::config {

void mustBeWord(const Reader& at, const std::string& word) {
  const bool plain = std::all_of(word.begin(), word.end(),
                                 [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
  if (!plain || word.empty() || word.size() >= link::kNameLength) {
    at.fail("is '" + word.substr(0, 80) + "'; expected at most 63 letters, digits, '_' and '-'");
  }
}

namespace {

YAML::Node paramsOf(const Reader& block) {
  const auto params = block.find("params");
  if (!params || params->entries().empty()) return YAML::Node(YAML::NodeType::Map);
  return params->node();
}

PluginConfig readPlugin(const std::string& name, const Reader& block) {
  PluginConfig plugin;
  plugin.name = name;
  plugin.place = block.place();
  plugin.type = block.textOr("type", name);
  plugin.thread = block.textOr("thread", "");
  plugin.params = paramsOf(block);
  mustBeWord(block, plugin.name);
  mustBeWord(block, plugin.type);
  return plugin;
}

// An item of a plain list: a name, or a map with `name`.
PluginConfig readItem(const Reader& item, std::vector<std::string>& warnings) {
  if (!item.node().IsMap()) {
    const std::string name = item.text();
    mustBeWord(item, name);
    return {name, name, {}, YAML::Node(YAML::NodeType::Map), item.place()};
  }
  item.knows({"name", "type", "thread", "params"}, warnings);
  return readPlugin(item.at("name", "{name: Homing, type: Homing}").text(), item);
}

std::vector<PluginConfig> readList(const Reader& block, std::string_view key, std::vector<std::string>& warnings) {
  std::vector<PluginConfig> plugins;
  const auto list = block.find(key);
  if (!list) return plugins;
  for (const Reader& item : list->items("[Homing, Sine]")) plugins.push_back(readItem(item, warnings));
  return plugins;
}

void giveThread(PluginConfig& plugin, const RtConfig& config) {
  std::vector<std::string> names;
  for (const auto& thread : config.threads) names.push_back(thread.name);
  if (plugin.thread.empty()) plugin.thread = names.front();
  if (std::find(names.begin(), names.end(), plugin.thread) != names.end()) return;
  throw ConfigError(plugin.place, "the plugin '" + plugin.name + "' is to run in the thread '" + plugin.thread +
                                      "', which is not in xbotcore_threads; there are " + link::listed(names) +
                                      didYouMean(plugin.thread, names));
}

void mustBeUnique(const RtConfig& config) {
  std::vector<const PluginConfig*> all;
  for (const auto* list : {&config.plugins, &config.io_plugins, &config.nrt_plugins}) {
    for (const auto& plugin : *list) {
      const auto twin =
          std::find_if(all.begin(), all.end(), [&](const auto* other) { return other->name == plugin.name; });
      if (twin != all.end()) {
        throw ConfigError(plugin.place, "the plugin '" + plugin.name + "' is there already in line " +
                                            std::to_string((*twin)->place.line) + "; names must be unique");
      }
      all.push_back(&plugin);
    }
  }
}

void append(std::vector<PluginConfig>& to, std::vector<PluginConfig> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

void readPlugins(const Reader& top, RtConfig& into) {
  if (const auto block = top.find("xbotcore_plugins")) {
    for (const auto& [name, value] : block->entries()) {
      value.knows({"thread", "type", "params"}, into.warnings);
      into.plugins.push_back(readPlugin(name, value));
    }
  }
  if (const auto block = top.find("XBotRTPlugins")) {
    block->knows({"plugins", "io_plugins"}, into.warnings);
    append(into.plugins, readList(*block, "plugins", into.warnings));
    append(into.io_plugins, readList(*block, "io_plugins", into.warnings));
  }
  if (const auto block = top.find("NRTPlugins")) {
    block->knows({"plugins"}, into.warnings);
    append(into.nrt_plugins, readList(*block, "plugins", into.warnings));
  }
  for (auto& plugin : into.plugins) giveThread(plugin, into);
  for (auto& plugin : into.nrt_plugins) giveThread(plugin, into);
  mustBeUnique(into);
}

}  // namespace robotui::rt::config
