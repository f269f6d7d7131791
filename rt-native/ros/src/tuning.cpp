#include "tuning.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::ros_bridge {
namespace {

using ros::TunableEntry;
using ros::TunableType;

const char* typeName(TunableType type) {
  switch (type) {
    case TunableType::kBool: return "bool";
    case TunableType::kInt: return "int";
    case TunableType::kDouble: break;
  }
  return "double";
}

std::vector<double> each(const std::vector<TunableEntry>& entries, double TunableEntry::*value) {
  std::vector<double> values(entries.size());
  std::transform(entries.begin(), entries.end(), values.begin(),
                 [&](const TunableEntry& entry) { return entry.*value; });
  return values;
}

template <typename Named>
void take(const std::vector<Named>& named, const std::vector<TunableEntry>& entries, std::vector<double>& values) {
  for (const Named& one : named) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const TunableEntry& entry) { return entry.name == one.name; });
    const auto value = static_cast<double>(one.value);
    if (found != entries.end() && std::isfinite(value))
      values[static_cast<std::size_t>(found - entries.begin())] = std::clamp(value, found->least, found->most);
  }
}

}  // namespace

dynamic_reconfigure::Config configOf(const std::vector<TunableEntry>& entries, const std::vector<double>& values) {
  dynamic_reconfigure::Config config;
  const auto add = [](auto& list, const std::string& name, auto value) {
    list.emplace_back();
    list.back().name = name;
    list.back().value = static_cast<decltype(list.back().value)>(value);
  };
  for (std::size_t i = 0; i < entries.size(); ++i) {
    switch (entries[i].type) {
      case TunableType::kBool: add(config.bools, entries[i].name, values[i] != 0 ? 1 : 0); break;
      case TunableType::kInt: add(config.ints, entries[i].name, std::lround(values[i])); break;
      case TunableType::kDouble: add(config.doubles, entries[i].name, values[i]); break;
    }
  }
  config.groups.emplace_back();
  config.groups.back().name = "Default";
  config.groups.back().state = 1;
  return config;
}

dynamic_reconfigure::ConfigDescription descriptionOf(const std::vector<TunableEntry>& entries) {
  dynamic_reconfigure::ConfigDescription description;
  description.groups.emplace_back();
  description.groups.back().name = "Default";
  for (const TunableEntry& entry : entries) {
    auto& parameter = description.groups.back().parameters.emplace_back();
    parameter.name = entry.name;
    parameter.type = typeName(entry.type);
    parameter.description = entry.description;
  }
  description.min = configOf(entries, each(entries, &TunableEntry::least));
  description.max = configOf(entries, each(entries, &TunableEntry::most));
  description.dflt = configOf(entries, each(entries, &TunableEntry::initial));
  return description;
}

void merge(const dynamic_reconfigure::Config& wanted, const std::vector<TunableEntry>& entries,
           std::vector<double>& values) {
  take(wanted.bools, entries, values);
  take(wanted.ints, entries, values);
  take(wanted.doubles, entries, values);
}

}  // namespace robotui::rt::ros_bridge
