// What of the robot is seen in ROS: /xbotcore/*, /tf and the parameter of its model. Made anew where the master was.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Imu.h>
#include <tf2_msgs/TFMessage.h>
#include <xbot_msgs/JointState.h>

#include "log_function.h"
#include "raw_message.h"
#include "robot.h"
#include "robotui/rt/config/plan.h"
#include "transforms.h"

namespace robotui::rt::ros_bridge {

class RobotTopics {
 public:
  // Services wait in `services` for threads of their own: an answer of the robot may take a while.
  RobotTopics(const config::RtConfig& config, const config::Plan& plan, const Transforms& transforms, Robot& robot,
              Requests& requests, ros::CallbackQueue& services, LogFunction log);

  // Publishes the newest state of the robot.
  void publish();

 private:
  void offerState();
  void offerSensors(const config::RtConfig& config);
  void offerPlugin(const std::string& name);
  void takeCommands();
  void command(const ros::MessageEvent<RawMessage const>& event);
  void publishSensors(const ros::Time& stamp);
  void publishTransforms(const ros::Time& stamp);
  void complain(const std::string& line);

  struct ImuTopic {
    ros::Publisher publisher;
    sensor_msgs::Imu message;
  };
  struct WrenchTopic {
    ros::Publisher publisher;
    geometry_msgs::WrenchStamped message;
  };

  const Transforms& transforms_;
  Robot& robot_;
  Requests& requests_;
  LogFunction log_;
  std::vector<std::string> names_;
  ros::NodeHandle node_{"/xbotcore"};
  ros::NodeHandle services_{"/xbotcore"};
  ros::Publisher states_;
  ros::Publisher moving_;
  ros::Publisher fixed_;
  ros::Subscriber commands_;
  std::vector<ros::ServiceServer> verbs_;
  std::vector<ImuTopic> imus_;
  std::vector<WrenchTopic> wrenches_;
  xbot_msgs::JointState state_;
  std::vector<link::JointCommand> references_;
  bool shows_references_;
  std::int64_t transforms_ns_ = 0;
  std::int64_t complained_ns_ = 0;
};

}  // namespace robotui::rt::ros_bridge
