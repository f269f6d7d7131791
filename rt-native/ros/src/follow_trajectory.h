// The action /xbotcore/PLUGIN/follow_joint_trajectory of a plugin of type JointTrajectory, as ros_control's
// joint_trajectory_controller has it: docs/rt-trajectories.md.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <control_msgs/FollowJointTrajectoryActionFeedback.h>
#include <control_msgs/FollowJointTrajectoryActionGoal.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "action_goals.h"
#include "log_function.h"
#include "message_shape.h"
#include "raw_message.h"
#include "robot.h"
#include "robotui/rt/plugin/channel.h"
#include "robotui/rt/plugin/trajectory_report.h"
#include "trajectory_goal.h"

namespace robotui::rt::ros_bridge {

class FollowTrajectory {
 public:
  // `robot` is the name of the control, `joints` are all of its joints. `channels` outlive it.
  FollowTrajectory(const std::string& plugin, const std::string& robot, std::vector<std::string> joints,
                   const ChannelDirectory& channels, LogFunction log);
  ~FollowTrajectory();
  FollowTrajectory(const FollowTrajectory&) = delete;
  FollowTrajectory& operator=(const FollowTrajectory&) = delete;

 private:
  using Goal = control_msgs::FollowJointTrajectoryGoal;
  using GoalStatus = actionlib_msgs::GoalStatus;

  // Between its arrival and the moment at which it is followed or refused.
  struct Pending {
    std::string id;
    Goal goal;
    ros::Time start;
    std::uint64_t tag = 0;  // 0: it is not told yet
    std::string stop;       // what ends it, once it is told
    std::int64_t told_ns = 0;
    bool cancelled = false;
  };
  struct Active {
    std::string id;
    std::uint64_t tag;
    std::string stop;
    std::vector<std::size_t> joints;  // by index in the robot
    control_msgs::FollowJointTrajectoryActionFeedback feedback;
    bool cancelled = false;
  };

  // All that follows runs in one thread, since a trajectory takes some time to be told.
  void open();
  void work();
  void turn();
  void take(const RawMessage& message);
  void take(const control_msgs::FollowJointTrajectoryActionGoal& message);
  void cancel(const actionlib_msgs::GoalID& which);
  void tell();
  link::Reply ask(const std::string& order);
  bool look();
  void followPending();
  void followActive();
  void accept();
  void giveFeedback(std::int64_t now);
  void endPending(std::uint8_t status, const TrajectoryResult& result);
  void endActive(std::uint8_t status, const TrajectoryResult& result);
  void end(const std::string& id, std::uint8_t status, const TrajectoryResult& result);
  void publishStatus();

  const std::string plugin_;
  const std::vector<std::string> joints_;
  LogFunction log_;
  MessageShape shape_;
  Requests requests_;
  Robot robot_;
  ChannelReader<TrajectoryReport> reports_;
  TrajectoryReport report_{};
  std::int64_t reported_ns_ = 0;  // when it said something new
  ActionGoals goals_;
  std::optional<Pending> pending_;
  std::optional<Active> active_;
  std::uint64_t named_ = 0;  // goals that came without an id
  std::int64_t fed_ns_ = 0;
  std::int64_t listed_ns_ = 0;

  ::ros::CallbackQueue queue_;
  ::ros::NodeHandle node_;
  ::ros::Publisher statuses_;
  ::ros::Publisher feedbacks_;
  ::ros::Publisher results_;
  ::ros::Subscriber goal_;
  ::ros::Subscriber cancel_;
  std::atomic<bool> goes_on_{true};
  std::thread thread_;  // last: it uses the others
};

}  // namespace robotui::rt::ros_bridge
