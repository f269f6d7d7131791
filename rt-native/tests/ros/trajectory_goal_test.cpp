#include "trajectory_goal.h"

#include <gtest/gtest.h>

namespace robotui::rt::ros_bridge {
namespace {

struct TrajectoryGoalTest : testing::Test {
  TrajectoryGoalTest() {
    goal.trajectory.joint_names = {"a", "b"};
    for (const double time : {1.0, 2.0}) {
      trajectory_msgs::JointTrajectoryPoint point;
      point.positions = {time, -time};
      point.time_from_start = ros::Duration(time);
      goal.trajectory.points.push_back(point);
    }
  }

  std::int32_t code() const {
    const auto objection = objectionTo(goal, robot, now);
    return objection ? objection->error_code : TrajectoryResult::SUCCESSFUL;
  }
  std::string why() const { return objectionTo(goal, robot, now).value_or(resultOf(0, "nothing")).error_string; }

  // What it says behind the tag.
  std::string said() const {
    std::string all;
    for (const std::string& order : ordersOf(goal, now).take()) all += order.substr(order.find(' ') + 1);
    return all;
  }

  static control_msgs::JointTolerance tolerance(const std::string& joint, double position) {
    control_msgs::JointTolerance made;
    made.name = joint;
    made.position = position;
    return made;
  }

  std::vector<std::string> robot{"a", "b", "c"};
  control_msgs::FollowJointTrajectoryGoal goal;
  ros::Time now{100.0};
};

TEST_F(TrajectoryGoalTest, IsSaidWithItsTolerances) {
  goal.path_tolerance = {tolerance("a", 0.1), tolerance("b", 0)};
  goal.goal_tolerance = {tolerance("b", -1)};
  goal.goal_time_tolerance = ros::Duration(0.5);
  EXPECT_EQ(code(), TrajectoryResult::SUCCESSFUL) << why();
  EXPECT_EQ(said(),
            "begin;joints a b;point 1;positions 1 -1;point 2;positions 2 -2;path 0.1 a;goal 0 b;patience 0.5;run");
}

TEST_F(TrajectoryGoalTest, BeginsWhenItsStampSays) {
  EXPECT_EQ(startOf(goal, now), now);
  goal.trajectory.header.stamp = ros::Time(103.0);
  EXPECT_EQ(startOf(goal, now).toSec(), 103);
  goal.trajectory.header.stamp = ros::Time(98.5);
  EXPECT_EQ(code(), TrajectoryResult::SUCCESSFUL);
  EXPECT_EQ(said(), "begin;joints a b;point 0.5;positions 2 -2;run") << "the first point has passed";
  goal.trajectory.header.stamp = ros::Time(97.0);
  EXPECT_EQ(code(), TrajectoryResult::OLD_HEADER_TIMESTAMP);
}

TEST_F(TrajectoryGoalTest, WhatIsWrongHasItsCode) {
  goal.path_tolerance = {tolerance("c", 0.1)};
  EXPECT_EQ(code(), TrajectoryResult::INVALID_GOAL);
  EXPECT_EQ(why(), "a tolerance is given of 'c', which is no joint of this trajectory");
  goal.path_tolerance = {tolerance("a", 0.1)};
  goal.path_tolerance[0].velocity = 1;
  EXPECT_EQ(code(), TrajectoryResult::INVALID_GOAL);
  goal.path_tolerance.clear();
  goal.trajectory.joint_names[1] = "b;stop";
  EXPECT_EQ(code(), TrajectoryResult::INVALID_JOINTS);
  EXPECT_EQ(why(), "'b;stop' is no joint of this robot");
  goal.trajectory.joint_names.clear();
  EXPECT_EQ(code(), TrajectoryResult::INVALID_JOINTS);
  goal.trajectory.joint_names = {"a"};
  goal.trajectory.points.clear();
  EXPECT_EQ(code(), TrajectoryResult::INVALID_GOAL);
}

}  // namespace
}  // namespace robotui::rt::ros_bridge
