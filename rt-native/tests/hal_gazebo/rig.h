// A HAL and the model of a world in another process, cycle by cycle.
#pragma once

#include <chrono>
#include <functional>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "gazebo_hal.h"
#include "robotui/rt/link/allocations.h"
#include "world_process.h"

namespace robotui::rt::hal::gazebo {

inline config::RobotDescription armOf(std::vector<std::string> joints) {
  config::RobotDescription robot{};
  robot.name = "arm";
  int id = 0;
  for (std::string& name : joints)
    robot.joints.push_back({++id, std::move(name), config::JointType::kRevolute, -2.0, 2.0, 1.0, 50.0});
  robot.imus.push_back({"tool", "tool"});
  robot.force_torques.push_back({"wrist", "hand"});
  return robot;
}

struct GazeboTest : testing::Test {
  static constexpr int kMisses = 3;
  config::RobotDescription robot = armOf({"shoulder", "elbow", "wrist"});
  std::string partition = ownPartition();
  std::unique_ptr<WorldProcess> world;
  GazeboHal hal;
  std::array<link::JointState, 3> joints{};
  std::array<link::ImuState, 1> imus{};
  std::array<link::ForceTorqueState, 1> force_torques{};
  Measurements measured{joints, imus, force_torques};
  std::array<Reference, 3> references{};
  std::string said;

  void begin(std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"partition=" + partition, "joints=shoulder,elbow,wrist,gripper"});
    options.insert(options.begin(), "imu=/world/default/model/arm/link/tool/sensor/imu/imu");
    options.insert(options.begin(),
                   "force_torque=/world/default/model/arm/joint/wrist/sensor/force_torque/forcetorque");
    world = std::make_unique<WorldProcess>(options);
  }

  // `more` is YAML behind the partition.
  void open(const std::string& more = "") {
    config::HalConfig config;
    config.misses_before_safe = kMisses;
    config.params = YAML::Load("{partition: " + partition + ", timeout_us: 300000" + more + "}");
    hal.open(robot, config, link::kMillisecond);
  }

  std::string refusal(const std::string& more = "") {
    try {
      open(more);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "it was opened";
  }

  void tell(const Reference& reference) { references.fill(reference); }

  Status cycle() {
    const Status status = hal.sense(measured);
    hal.move(references);
    for (const std::string& sentence : hal.news()) said += sentence + "\n";
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return status;
  }

  // With patience for a loaded machine.
  bool cycleUntil(const std::function<bool(Status)>& condition) {
    for (const std::int64_t end = link::now() + 20 * link::kSecond; link::now() < end;) {
      if (condition(cycle())) return true;
    }
    return false;
  }
  bool cycleUntil(Status wanted) {
    return cycleUntil([&](Status status) { return status == wanted; });
  }
  bool cycleUntilSaid(const std::string& words) {
    return cycleUntil([&](Status) { return said.find(words) != std::string::npos; });
  }

  // How often the joint was told something.
  int told(const std::string& joint) {
    std::istringstream words(world->say("joint " + joint));
    std::string way;
    double ignored = 0;
    int count = 0;
    words >> way >> ignored >> ignored >> count;
    return count;
  }
};

}  // namespace robotui::rt::hal::gazebo
