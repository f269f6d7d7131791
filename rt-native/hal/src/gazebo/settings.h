// What HALInterface.params says to the interface to Gazebo.
#pragma once

#include <cstdint>
#include <string>

#include "robotui/rt/config/config.h"

namespace robotui::rt::hal::gazebo {

enum class AtEnd : std::uint8_t {
  kHold,   // joints that follow a velocity or an effort get zero of it, and hold where they are if they can
  kPause,  // the same, and the world is paused
  kLeave   // nothing is sent behind the last command
};

// With {world}, {model} and {joint}, {sensor} or {link}, which are filled in.
struct TopicPatterns {
  std::string joint_state = "/world/{world}/model/{model}/joint_state";
  std::string position = "/model/{model}/joint/{joint}/0/cmd_pos";
  std::string velocity = "/model/{model}/joint/{joint}/cmd_vel";
  std::string effort = "/model/{model}/joint/{joint}/cmd_force";
  std::string imu = "/world/{world}/model/{model}/link/{link}/sensor/imu/imu";
  std::string force_torque = "/world/{world}/model/{model}/joint/{sensor}/sensor/force_torque/forcetorque";
  std::string statistics = "/world/{world}/stats";
  std::string control = "/world/{world}/control";
};

struct Settings {
  std::string world = "default";
  std::string model;                  // the robot's name
  std::string partition;              // empty is that of the environment, or of host and user
  std::string address = "127.0.0.1";  // of the network interface; only where IGN_IP does not say it
  std::int64_t timeout_ns = 0;
  AtEnd at_end = AtEnd::kHold;
  TopicPatterns topics;
};

// Throws config::ConfigError.
Settings readSettings(const config::HalConfig& config, const config::RobotDescription& robot);

}  // namespace robotui::rt::hal::gazebo
