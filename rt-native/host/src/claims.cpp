#include <algorithm>
#include <set>

#include "robotui/rt/host/hosted_plugin.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::host {
namespace {

std::vector<std::string> list(const YAML::Node& params, const char* key) {
  const YAML::Node node = params.IsMap() ? params[key] : YAML::Node();
  if (!node || node.IsNull()) {
    return {};
  }
  try {
    return node.IsScalar() ? std::vector<std::string>{node.as<std::string>()} : node.as<std::vector<std::string>>();
  } catch (const YAML::Exception&) {
    throw PluginError("`" + std::string(key) + "` must be a list of names, such as [a, b].");
  }
}

template <typename Items>
std::string namesOf(const Items& items) {
  return link::listed(
      items, [](const auto& item) { return item.name; }, "none");
}

void addChain(const std::string& name, const config::RobotDescription& robot, std::set<std::string>& wanted) {
  const auto chain =
      std::find_if(robot.chains.begin(), robot.chains.end(), [&](const auto& c) { return c.name == name; });
  if (chain == robot.chains.end()) {
    throw PluginError("The robot has no chain '" + name + "'. It has: " + namesOf(robot.chains) + ".");
  }
  wanted.insert(chain->joints.begin(), chain->joints.end());
}

void addJoint(const std::string& name, const config::RobotDescription& robot, std::set<std::string>& wanted) {
  if (std::none_of(robot.joints.begin(), robot.joints.end(), [&](const auto& j) { return j.name == name; })) {
    throw PluginError("The robot has no joint '" + name + "'. It has: " + namesOf(robot.joints) + ".");
  }
  wanted.insert(name);
}

}  // namespace

std::vector<std::string> claimedJoints(const YAML::Node& params, const config::RobotDescription& robot) {
  std::set<std::string> wanted;
  if (params.IsDefined()) {
    for (const std::string& name : list(params, "chains")) {
      addChain(name, robot, wanted);
    }
    for (const std::string& name : list(params, "joints")) {
      addJoint(name, robot, wanted);
    }
  }
  std::vector<std::string> claimed;
  for (const auto& joint : robot.joints) {
    if (wanted.count(joint.name) != 0) {
      claimed.push_back(joint.name);
    }
  }
  return claimed;
}

}  // namespace robotui::rt::host
