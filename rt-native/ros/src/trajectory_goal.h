// A goal of control_msgs/FollowJointTrajectory as what the plugin JointTrajectory is told.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <control_msgs/FollowJointTrajectoryGoal.h>
#include <control_msgs/FollowJointTrajectoryResult.h>

#include "robotui/rt/link/trajectory_orders.h"

namespace robotui::rt::ros_bridge {

using TrajectoryResult = control_msgs::FollowJointTrajectoryResult;

TrajectoryResult resultOf(std::int32_t code, std::string text);

// What speaks against it before any plugin is asked; the plugin checks all else. `joints` are those of the robot.
std::optional<TrajectoryResult> objectionTo(const control_msgs::FollowJointTrajectoryGoal& goal,
                                            std::span<const std::string> joints, const ros::Time& now);

// When it is to begin: now, where its stamp is zero or has passed.
ros::Time startOf(const control_msgs::FollowJointTrajectoryGoal& goal, const ros::Time& now);

// Of a goal that nothing speaks against; points whose time has passed are left out.
link::TrajectoryOrders ordersOf(const control_msgs::FollowJointTrajectoryGoal& goal, const ros::Time& now);

}  // namespace robotui::rt::ros_bridge
