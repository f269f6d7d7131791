#include "task_parameters.h"

#include <algorithm>

#include "chosen_joints.h"
#include "robotui/rt/robot/rigid_tree.h"

namespace robotui::rt::plugins {
namespace {

constexpr std::array<const char*, 6> kAxes{"x", "y", "z", "roll", "pitch", "yaw"};

bool isKnown(const std::string& name, const RobotInterface& robot) {
  const auto& postures = robot.description().postures;
  return std::any_of(postures.begin(), postures.end(), [&](const auto& posture) { return posture.name == name; });
}

std::array<bool, 6> maskOf(const config::Reader& at) {
  if (!at.node().IsSequence()) {
    const std::string word = at.oneOf({"pose", "position", "orientation"});
    const bool position = word != "orientation";
    const bool orientation = word != "position";
    return {position, position, position, orientation, orientation, orientation};
  }
  std::array<bool, 6> mask{};
  for (const auto& item : at.items("[x, y, z]")) {
    const std::string axis = item.oneOf({"x", "y", "z", "roll", "pitch", "yaw"});
    mask[static_cast<std::size_t>(std::find(kAxes.begin(), kAxes.end(), axis) - kAxes.begin())] = true;
  }
  if (std::none_of(mask.begin(), mask.end(), [](bool is_in) { return is_in; }))
    at.fail("is empty: leave it out for all");
  return mask;
}

SpeedLimits speedsOf(const config::Reader& at, const SpeedLimits& otherwise) {
  return {at.realOr("linear_speed", otherwise.linear, 1e-4, 10),
          at.realOr("angular_speed", otherwise.angular, 1e-4, 20)};
}

TaskDescription taskOf(const std::string& name, const config::Reader& at, RobotInterface& robot,
                       const TaskDescription& defaults) {
  at.knowsOnly({"chain", "link", "base", "priority", "mask", "linear_speed", "angular_speed", "active"});
  TaskDescription task = defaults;
  task.name = name;
  if (name.empty() || name.find(' ') != std::string::npos) at.fail("needs a name without spaces");
  if (const auto chain = at.find("chain")) {
    const KinematicChain* found = robot.findChain(chain->text());
    if (found == nullptr) chain->fail("is no chain of the SRDF");
    task.base = found->baseLink();
    task.link = found->tipLink();
  }
  task.link = at.textOr("link", task.link);
  task.base = at.textOr("base", task.base);
  if (task.link.empty()) at.fail("needs a `chain`, or a `link`");
  task.priority = static_cast<int>(at.wholeOr("priority", task.priority, 1, 100));
  task.speeds = speedsOf(at, task.speeds);
  task.active = at.flagOr("active", true);
  if (const auto mask = at.find("mask")) task.mask = maskOf(*mask);
  return task;
}

std::vector<TaskDescription> tasksOf(const config::Reader& params, RobotInterface& robot) {
  TaskDescription defaults;
  defaults.base = buildRigidTree(robot.description()).bodies.front().name;
  defaults.speeds = speedsOf(params, defaults.speeds);
  defaults.timeout = params.realOr("velocity_timeout", defaults.timeout, 0.01, 10);
  std::vector<TaskDescription> tasks;
  for (const auto& [name, task] : params.at("tasks", "{hand: {chain: left_arm}}").entries())
    tasks.push_back(taskOf(name, task, robot, defaults));
  if (tasks.empty()) params.at("tasks", "{hand: {chain: left_arm}}").fail("has no task");
  std::stable_sort(tasks.begin(), tasks.end(), [](auto& a, auto& b) { return a.priority < b.priority; });
  return tasks;
}

}  // namespace

TaskParameters readTaskParameters(const config::Reader& params, RobotInterface& robot) {
  params.knowsOnly(
      {"tasks", "joints", "chains", "posture", "posture_speed", "linear_speed", "angular_speed", "velocity_timeout"});
  TaskParameters result;
  result.tasks = tasksOf(params, robot);
  result.joints = chosenJoints(params, robot);
  result.posture = params.textOr("posture", "");
  if (!result.posture.empty() && !isKnown(result.posture, robot))
    params.at("posture", "home").fail("is no posture of the SRDF");
  result.posture_speed = params.realOr("posture_speed", result.posture_speed, 0.001, 1);
  return result;
}

}  // namespace robotui::rt::plugins
