// How a plugin uses ROS from its control loop: it swings one joint about where it was, and everything of the swing can
// be seen and changed in ROS.
#pragma once

#include <memory>

#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>

#include "robotui/rt/ros/node.h"

namespace robotui::rt::plugins {

// Parameter: `joint` (the first one where it is not given). Beneath /xbotcore/PLUGIN: the topic `position` (Float64,
// where the joint is), the topic `offset` (Float64, added to the centre), the service `hold` (SetBool), and tunable
// `amplitude` (rad) and `frequency` (Hz).
class RosExample final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) override;
  RtStatus control_loop(double time, double period) override;
  std::string_view status() const noexcept override { return held_ ? "holding" : "swinging"; }
  void close() override { node_.reset(); }

 private:
  bool hold(const std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  std::unique_ptr<ros::Node> node_;
  ros::Publisher<std_msgs::Float64> positions_;
  ros::Tunable<double> amplitude_;
  ros::Tunable<double> frequency_;
  Joint* joint_ = nullptr;
  double centre_ = 0;
  double offset_ = 0;
  double phase_ = 0;
  bool held_ = false;
};

}  // namespace robotui::rt::plugins
