#include "action_goals.h"

#include <gtest/gtest.h>

namespace robotui::rt::ros_bridge {
namespace {

using Status = ActionGoals::Status;

actionlib_msgs::GoalID idOf(const std::string& id, double stamp = 0) {
  actionlib_msgs::GoalID made;
  made.id = id;
  made.stamp = ros::Time(stamp);
  return made;
}

struct ActionGoalsTest : testing::Test {
  std::uint8_t status(const std::string& id) const {
    const Status* found = goals.find(id);
    return found == nullptr ? std::uint8_t{Status::LOST} : found->status;
  }

  ActionGoals goals;
  ros::Time now{100.0};
};

TEST_F(ActionGoalsTest, AGoalThatCameTwiceIsOne) {
  EXPECT_TRUE(goals.add(idOf("a"), now));
  EXPECT_FALSE(goals.add(idOf("a"), now));
  EXPECT_EQ(goals.list(now).status_list.size(), 1U);
}

TEST_F(ActionGoalsTest, OneAtItsEndIsSeenForAWhileAndThenForgotten) {
  goals.add(idOf("a"), now);
  goals.add(idOf("b"), now);
  goals.set("a", Status::SUCCEEDED, "", now);
  EXPECT_EQ(goals.list(now + ros::Duration(4)).status_list.size(), 2U);
  const auto left = goals.list(now + ros::Duration(6)).status_list;
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].goal_id.id, "b");
}

TEST_F(ActionGoalsTest, ACancelMeansOneOrAllOrThoseUpToAStamp) {
  for (const auto& [id, stamp] : {std::pair{"a", 10.0}, {"b", 20.0}, {"c", 30.0}}) goals.add(idOf(id, stamp), now);
  goals.set("a", Status::ACTIVE, "", now);
  EXPECT_EQ(goals.cancel(idOf("c"), now), std::vector<std::string>{"c"});
  EXPECT_EQ(status("c"), Status::RECALLING);
  EXPECT_EQ(goals.cancel(idOf("", 10), now), std::vector<std::string>{"a"});
  EXPECT_EQ(status("a"), Status::PREEMPTING);
  goals.set("a", Status::PREEMPTED, "", now);
  EXPECT_EQ(goals.cancel(idOf(""), now), (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(status("a"), Status::PREEMPTED);
}

TEST_F(ActionGoalsTest, ACancelThatComesBeforeItsGoalCounts) {
  EXPECT_TRUE(goals.cancel(idOf("late"), now).empty());
  EXPECT_TRUE(goals.cancel(idOf(""), now).empty()) << "there is no goal yet";
  EXPECT_FALSE(goals.add(idOf("late"), now));
  EXPECT_EQ(status("late"), Status::RECALLED);
}

}  // namespace
}  // namespace robotui::rt::ros_bridge
