// The joints that a plugin is to command: `joints` and `chains` of its parameters, or all of the robot.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

inline void addJoint(const config::Reader& at, Joint* joint, std::vector<Joint*>& chosen) {
  if (joint == nullptr) at.fail("is no joint of the joint map");
  if (std::find(chosen.begin(), chosen.end(), joint) == chosen.end()) chosen.push_back(joint);
}

inline void addChain(const config::Reader& at, KinematicChain* chain, std::vector<Joint*>& chosen) {
  if (chain == nullptr) at.fail("is no chain of the SRDF");
  for (int i = 0; i < chain->size(); ++i) addJoint(at, &chain->joint(i), chosen);
}

// Without either key all joints of the robot. Not real time; throws ConfigError.
inline std::vector<Joint*> chosenJoints(const config::Reader& params, RobotInterface& robot) {
  std::vector<Joint*> chosen;
  const auto joints = params.find("joints");
  const auto chains = params.find("chains");
  if (joints) {
    for (const auto& item : joints->items("[joint_1, joint_2]")) addJoint(item, robot.findJoint(item.text()), chosen);
  }
  if (chains) {
    for (const auto& item : chains->items("[left_arm]")) addChain(item, robot.findChain(item.text()), chosen);
  }
  if (!joints && !chains) {
    for (int i = 0; i < robot.getJointNum(); ++i) chosen.push_back(&robot.joint(i));
  }
  return chosen;
}

inline std::vector<std::string> namesOf(const std::vector<Joint*>& joints) {
  std::vector<std::string> names;
  names.reserve(joints.size());
  for (const Joint* joint : joints) names.push_back(joint->name());
  return names;
}

}  // namespace robotui::rt::plugins
