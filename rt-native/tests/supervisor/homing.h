// The robot's configurations as they are shipped, and whether it has come home.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/board.h"
#include "running_robot.h"

namespace robotui::rt::supervisor {

inline constexpr double kNear = 0.02;  // rad: joints of the simulation with forces give way a little
inline constexpr double kSomeWay = 0.3;

// As it is shipped, but from anywhere, in haste, and without a word about machines that run tests and are late now and
// then.
inline YAML::Node shipped(const std::string& robot, const std::string& hardware) {
  const std::filesystem::path folder = std::filesystem::path(RT_CONFIGS) / robot;
  YAML::Node config = YAML::LoadFile(folder / ("rt-" + hardware + ".yaml"));
  for (const char* key : {"urdf_path", "srdf_path", "joint_map_path"}) {
    config["XBotInterface"][key] = (folder / config["XBotInterface"][key].as<std::string>()).string();
  }
  config["MasterCommunicationInterface"]["framework_name"] = "robotui";
  config["HALInterface"]["misses_before_safe"] = 1000;
  config["xbotcore_plugins"]["Homing"]["params"]["speed"] = 1;
  return config;
}

// Where the joints of a posture are to be, within their limits.
inline std::map<std::string, double> goals(const config::RobotDescription& robot, const std::string& posture) {
  std::map<std::string, double> wanted;
  for (const config::Posture& each : robot.postures) {
    for (const auto& [name, position] : each.joints) {
      const auto joint =
          std::find_if(robot.joints.begin(), robot.joints.end(), [&](const auto& j) { return j.name == name; });
      if (each.name == posture && joint != robot.joints.end())
        wanted[name] = std::clamp(position, joint->lower, joint->upper);
    }
  }
  return wanted;
}

// How far the joint that is farthest from its goal is away from it.
inline double farthest(RunningRobot& robot, const std::map<std::string, double>& wanted) {
  const auto board = robot.board();
  const auto frame = robot.frame();
  double most = 0;
  for (std::uint32_t i = 0; i < board->joints; ++i) {
    const auto goal = wanted.find(std::string(link::view(board->joint[i].name)));
    if (goal != wanted.end()) most = std::max(most, std::abs(frame->joints[i].link_position - goal->second));
  }
  return most;
}

// Starts Homing in a robot that runs, and waits for it.
inline void expectHomeOf(RunningRobot& robot, const std::map<std::string, double>& wanted) {
  const auto started = robot.ask("switch Homing 1");
  ASSERT_TRUE(started.ok) << started.text << robot.output();
  EXPECT_TRUE(eventually([&] { return farthest(robot, wanted) < kNear; }))
      << farthest(robot, wanted) << " from home; " << robot.output();
  EXPECT_TRUE(eventually([&] { return robot.ask("status Homing").text == "running: at home"; }))
      << robot.ask("status Homing").text;
}

inline void expectHome(const YAML::Node& config, const std::string& posture) {
  RunningRobot robot(WholeConfig{YAML::Dump(config)});
  robot.client();
  const auto wanted = goals(config::load(robot.config(), {}).robot, posture);
  ASSERT_FALSE(wanted.empty());
  EXPECT_GT(farthest(robot, wanted), kSomeWay) << "it must have some way to go";
  expectHomeOf(robot, wanted);
}

}  // namespace robotui::rt::supervisor
