// A model of a Gazebo world on the real transport: one robot with joints of the first order, an IMU and a force-torque
// sensor, with the topics, messages and services of the simulator's own systems. It misbehaves when it is told to.
#pragma once

#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/model.pb.h>
#include <ignition/msgs/world_control.pb.h>
#include <ignition/transport/Node.hh>

#include "world_options.h"

namespace robotui::rt::hal::gazebo {

// Of the simulator there is one controller for each way; here the one that was told last moves the joint.
struct WorldJoint {
  std::string name;
  double position = 0;
  double velocity = 0;
  double effort = 0;
  char way = 'n';  // p, v or e: the controller; n is none yet
  double wanted = 0;
  int told = 0;  // commands
};

class World {
 public:
  explicit World(const WorldOptions& options);

  // One millisecond of a clock.
  void tick();

  // "pause", "run", "reset", "slow F", "nan JOINT", "lack JOINT", "sound", "late", "silent", "speak", "garbage", "joint
  // NAME", "listeners": the answer is one line.
  std::string obey(const std::string& line);

 private:
  using Node = ignition::transport::Node;

  void advertise();
  void subscribe(WorldJoint& joint);
  void step();
  ignition::msgs::Model state() const;
  void send();
  void sendSensors();
  void sendStatistics();
  bool control(const ignition::msgs::WorldControl& request);
  void reset();
  std::string describe(const std::string& name) const;

  WorldOptions options_;
  mutable std::recursive_mutex mutex_;
  Node node_;
  std::map<std::string, WorldJoint> joints_;
  Node::Publisher state_;
  Node::Publisher statistics_;
  Node::Publisher clock_;
  Node::Publisher imu_;
  Node::Publisher force_torque_;
  std::optional<ignition::msgs::Model> kept_;  // to be sent late
  std::string nan_;
  std::string lack_;
  double factor_ = 1;
  double owed_ = 0;  // simulated time that the clock is ahead, ms
  long simulated_ms_ = 0;
  long ticks_ = 0;
  bool paused_ = false;
  bool silent_ = false;
  bool late_ = false;
};

}  // namespace robotui::rt::hal::gazebo
