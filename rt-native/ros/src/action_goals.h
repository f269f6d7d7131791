// The goals of an action and how they stand, as actionlib's protocol has them.
#pragma once

#include <string>
#include <vector>

#include <actionlib_msgs/GoalStatusArray.h>

namespace robotui::rt::ros_bridge {

// For one thread. Times are those of the caller's clock.
class ActionGoals {
 public:
  using Status = actionlib_msgs::GoalStatus;

  // A goal that came; false where it came before, or a cancel for it did, which has then ended it.
  bool add(const actionlib_msgs::GoalID& id, const ros::Time& now);

  // Of a goal that was added. One at an end stays in the list for a while, so that its client sees it.
  void set(const std::string& id, std::uint8_t status, const std::string& text, const ros::Time& now);

  // Those that a cancel message means: one by its id, those up to its stamp, all where it has neither. They are then
  // preempting or recalling. One that is not known yet is recalled when it comes.
  std::vector<std::string> cancel(const actionlib_msgs::GoalID& which, const ros::Time& now);

  const Status* find(const std::string& id) const noexcept;

  // What is to be published; forgets what ended some time ago.
  actionlib_msgs::GoalStatusArray list(const ros::Time& now);

  static bool isAtAnEnd(std::uint8_t status) noexcept;

 private:
  struct Goal {
    Status status;
    ros::Time changed;
    bool has_come = true;  // else a cancel alone
  };
  Goal* at(const std::string& id) noexcept;

  std::vector<Goal> goals_;
};

}  // namespace robotui::rt::ros_bridge
