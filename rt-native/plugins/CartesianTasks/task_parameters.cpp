#include "task_parameters.h"

#include <algorithm>

#include "chosen_joints.h"
#include "robotui/rt/robot/rigid_tree.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kMostMetres = 10;

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

Eigen::Vector3d pointOf(const config::Reader& at) {
  const auto numbers = at.items("[0, 0, 0.1]");
  if (numbers.size() != 3) at.fail("has " + std::to_string(numbers.size()) + " numbers; expected 3, in m");
  return {numbers[0].real(-kMostMetres, kMostMetres), numbers[1].real(-kMostMetres, kMostMetres),
          numbers[2].real(-kMostMetres, kMostMetres)};
}

Capsule capsuleOf(const config::Reader& at) {
  at.knowsOnly({"from", "to", "radius"});
  const Eigen::Vector3d from = pointOf(at.at("from", "[0, 0, 0]"));
  const auto to = at.find("to");
  return {from, to ? pointOf(*to) : from, at.at("radius", "0.05").real(1e-4, kMostMetres)};
}

DistanceParameters distanceOf(const config::Reader& at) {
  at.knowsOnly({"margin", "influence", "links", "capsules"});
  DistanceParameters distance;
  distance.margin = at.realOr("margin", distance.margin, 0, 1);
  distance.influence = at.realOr("influence", distance.influence, 0.01, 1);
  if (const auto links = at.find("links")) {
    for (const auto& link : links->items("[left_hand, right_hand]")) distance.links.push_back(link.text());
  }
  if (const auto capsules = at.find("capsules")) {
    for (const auto& [link, capsule] : capsules->entries()) distance.own.emplace_back(link, capsuleOf(capsule));
  }
  return distance;
}

}  // namespace

TaskParameters readTaskParameters(const config::Reader& params, RobotInterface& robot) {
  params.knowsOnly({"tasks", "joints", "chains", "posture", "posture_speed", "linear_speed", "angular_speed",
                    "velocity_timeout", "distance"});
  TaskParameters result;
  result.tasks = tasksOf(params, robot);
  result.joints = chosenJoints(params, robot);
  result.posture = params.textOr("posture", "");
  if (!result.posture.empty() && !isKnown(result.posture, robot))
    params.at("posture", "home").fail("is no posture of the SRDF");
  result.posture_speed = params.realOr("posture_speed", result.posture_speed, 0.001, 1);
  if (const auto distance = params.find("distance")) result.distance = distanceOf(*distance);
  return result;
}

}  // namespace robotui::rt::plugins
