#include "action_goals.h"

#include <algorithm>

namespace robotui::rt::ros_bridge {
namespace {

using Status = ActionGoals::Status;

constexpr double kKeptSeconds = 5;
constexpr std::size_t kMostGoals = 1000;  // a list that names so many of the last seconds helps nobody

}  // namespace

bool ActionGoals::isAtAnEnd(std::uint8_t status) noexcept {
  switch (status) {
    case Status::PREEMPTED:
    case Status::SUCCEEDED:
    case Status::ABORTED:
    case Status::REJECTED:
    case Status::RECALLED: return true;
    default: return false;
  }
}

ActionGoals::Goal* ActionGoals::at(const std::string& id) noexcept {
  const auto found =
      std::find_if(goals_.begin(), goals_.end(), [&](const Goal& goal) { return goal.status.goal_id.id == id; });
  return found == goals_.end() ? nullptr : &*found;
}

const Status* ActionGoals::find(const std::string& id) const noexcept {
  const auto found =
      std::find_if(goals_.begin(), goals_.end(), [&](const Goal& goal) { return goal.status.goal_id.id == id; });
  return found == goals_.end() ? nullptr : &found->status;
}

bool ActionGoals::add(const actionlib_msgs::GoalID& id, const ros::Time& now) {
  if (Goal* known = at(id.id); known != nullptr) {
    if (!known->has_come) set(id.id, Status::RECALLED, "cancelled before it came", now);
    return false;
  }
  if (goals_.size() == kMostGoals) goals_.erase(goals_.begin());
  Goal goal;
  goal.status.goal_id = id;
  goal.status.status = Status::PENDING;
  goal.changed = now;
  goals_.push_back(goal);
  return true;
}

void ActionGoals::set(const std::string& id, std::uint8_t status, const std::string& text, const ros::Time& now) {
  Goal* goal = at(id);
  if (goal == nullptr) return;
  goal->status.status = status;
  goal->status.text = text;
  goal->changed = now;
  goal->has_come = true;
}

std::vector<std::string> ActionGoals::cancel(const actionlib_msgs::GoalID& which, const ros::Time& now) {
  std::vector<std::string> meant;
  const bool is_all = which.id.empty() && which.stamp.isZero();
  for (Goal& goal : goals_) {
    const actionlib_msgs::GoalID& id = goal.status.goal_id;
    const bool is_older = !which.stamp.isZero() && id.stamp <= which.stamp;
    if (isAtAnEnd(goal.status.status) || !(is_all || id.id == which.id || is_older)) continue;
    goal.status.status = goal.status.status == Status::PENDING ? Status::RECALLING : Status::PREEMPTING;
    goal.changed = now;
    if (goal.has_come) meant.push_back(id.id);
  }
  if (!which.id.empty() && at(which.id) == nullptr && goals_.size() < kMostGoals) {
    Goal early;
    early.status.goal_id = which;
    early.status.status = Status::RECALLING;
    early.changed = now;
    early.has_come = false;
    goals_.push_back(early);
  }
  return meant;
}

actionlib_msgs::GoalStatusArray ActionGoals::list(const ros::Time& now) {
  std::erase_if(goals_, [&](const Goal& goal) {
    return (isAtAnEnd(goal.status.status) || !goal.has_come) && (now - goal.changed).toSec() > kKeptSeconds;
  });
  actionlib_msgs::GoalStatusArray array;
  array.header.stamp = now;
  for (const Goal& goal : goals_) array.status_list.push_back(goal.status);
  return array;
}

}  // namespace robotui::rt::ros_bridge
