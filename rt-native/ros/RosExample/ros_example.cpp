#include "ros_example.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robotui::rt::plugins {
namespace {

constexpr double kMostOffset = 0.5;
constexpr std::size_t kSentence = 64;

}  // namespace

bool RosExample::init_control_plugin(Setup& setup) {
  RobotInterface& robot = setup.robot();
  const std::string wanted =
      setup.params()["joint"] ? setup.params()["joint"].as<std::string>() : robot.joint(0).name();
  for (int i = 0; i < robot.getJointNum(); ++i) {
    joint_ = robot.joint(i).name() == wanted ? &robot.joint(i) : joint_;
  }
  if (joint_ == nullptr) {
    setup.fail("The robot has no joint '" + wanted + "'.");
    return false;
  }
  setup.claim({wanted});

  node_ = std::make_unique<ros::Node>(setup);
  positions_ = node_->advertise<std_msgs::Float64>("position");
  node_->subscribe<std_msgs::Float64>("offset", [this](const std_msgs::Float64& message) {
    if (std::isfinite(message.data)) offset_ = std::clamp(message.data, -kMostOffset, kMostOffset);
  });
  std_srvs::SetBool room;
  room.response.message.resize(kSentence);  // copies of it have that room
  node_->serve<std_srvs::SetBool>(
      "hold", [this](const auto& request, auto& response) { return hold(request, response); }, {}, room);
  amplitude_ = node_->tune("amplitude", 0.1, 0.0, 0.5, "how far the joint swings to each side, rad");
  frequency_ = node_->tune("frequency", 0.2, 0.0, 1.0, "how often, Hz");
  node_->open();
  return true;
}

bool RosExample::hold(const std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  held_ = request.data != 0;
  response.success = 1;
  response.message.assign(held_ ? "holds" : "swings");  // fits what was reserved
  return true;
}

RtStatus RosExample::on_start(double /*time*/) {
  centre_ = joint_->getJointPosition();
  phase_ = 0;
  offset_ = 0;
  return RtStatus::ok();
}

RtStatus RosExample::control_loop(double /*time*/, double period) {
  node_->spin();
  if (!held_) phase_ = std::fmod(phase_ + 2 * std::numbers::pi * frequency_ * period, 2 * std::numbers::pi);
  joint_->setPositionReference(centre_ + offset_ + amplitude_ * std::sin(phase_));
  std_msgs::Float64 message;
  message.data = joint_->getJointPosition();
  positions_.publish(message);
  return RtStatus::ok();
}

}  // namespace robotui::rt::plugins
