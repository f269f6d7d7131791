#include "trajectory_goal.h"

#include <algorithm>
#include <utility>

namespace robotui::rt::ros_bridge {
namespace {

using Goal = control_msgs::FollowJointTrajectoryGoal;
using Tolerance = control_msgs::JointTolerance;

bool isAmong(std::span<const std::string> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<TrajectoryResult> invalid(std::string text) {
  return resultOf(TrajectoryResult::INVALID_GOAL, std::move(text));
}

std::optional<TrajectoryResult> objectionTo(const std::vector<Tolerance>& tolerances,
                                            std::span<const std::string> joints) {
  for (const Tolerance& each : tolerances) {
    if (!isAmong(joints, each.name))
      return invalid("a tolerance is given of '" + each.name + "', which is no joint of this trajectory");
    if (each.velocity > 0 || each.acceleration > 0)
      return invalid("a tolerance of the velocity or acceleration of " + each.name +
                     " is given: only that of its position is watched");
  }
  return std::nullopt;
}

// How long ago it began.
ros::Duration begunBefore(const Goal& goal, const ros::Time& now) {
  const ros::Time stamp = goal.trajectory.header.stamp;
  return stamp.isZero() || stamp >= now ? ros::Duration(0) : now - stamp;
}

// 0 is the default of the plugin, below it any.
void tell(link::TrajectoryOrders& orders, const char* verb, const std::vector<Tolerance>& tolerances) {
  for (const Tolerance& each : tolerances) {
    if (each.position != 0) orders.say(verb, std::max(each.position, 0.0), each.name);
  }
}

}  // namespace

TrajectoryResult resultOf(std::int32_t code, std::string text) {
  TrajectoryResult result;
  result.error_code = code;
  result.error_string = std::move(text);
  return result;
}

std::optional<TrajectoryResult> objectionTo(const Goal& goal, std::span<const std::string> joints,
                                            const ros::Time& now) {
  const auto& trajectory = goal.trajectory;
  if (trajectory.joint_names.empty()) return resultOf(TrajectoryResult::INVALID_JOINTS, "no joint is named");
  for (const std::string& name : trajectory.joint_names) {
    if (!isAmong(joints, name))
      return resultOf(TrajectoryResult::INVALID_JOINTS, "'" + name + "' is no joint of this robot");
  }
  if (trajectory.points.empty()) return invalid("there is no point");
  for (const auto* tolerances : {&goal.path_tolerance, &goal.goal_tolerance}) {
    if (auto objection = objectionTo(*tolerances, trajectory.joint_names)) return objection;
  }
  const ros::Duration passed = begunBefore(goal, now);
  if (passed > ros::Duration(0) && trajectory.points.back().time_from_start <= passed)
    return resultOf(TrajectoryResult::OLD_HEADER_TIMESTAMP,
                    "its last point was to be reached " +
                        std::to_string((passed - trajectory.points.back().time_from_start).toSec()) + " s ago");
  return std::nullopt;
}

ros::Time startOf(const Goal& goal, const ros::Time& now) { return std::max(goal.trajectory.header.stamp, now); }

link::TrajectoryOrders ordersOf(const Goal& goal, const ros::Time& now) {
  link::TrajectoryOrders orders;
  orders.joints(goal.trajectory.joint_names);
  const ros::Duration passed = begunBefore(goal, now);
  for (const auto& point : goal.trajectory.points) {
    const ros::Duration left = point.time_from_start - passed;
    if (passed > ros::Duration(0) && left <= ros::Duration(0)) continue;
    orders.point(left.toSec());
    orders.values("positions", point.positions);
    orders.values("velocities", point.velocities);
    orders.values("accelerations", point.accelerations);
  }
  tell(orders, "path", goal.path_tolerance);
  tell(orders, "goal", goal.goal_tolerance);
  if (!goal.goal_time_tolerance.isZero()) orders.say("patience", std::max(goal.goal_time_tolerance.toSec(), 0.0));
  return orders;
}

}  // namespace robotui::rt::ros_bridge
