// The robots that tests are made with: our own, and real ones where they lie.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "robotui/rt/config/config.h"

namespace robotui::rt {

using RobotPtr = std::shared_ptr<const config::RobotDescription>;

inline RobotPtr ownRobot(const std::string& name, bool floating) {
  const std::filesystem::path folder = std::filesystem::path(RT_CONFIGS) / name;
  return std::make_shared<config::RobotDescription>(
      config::describe(folder / (name + ".urdf"), folder / (name + ".srdf"), folder / "joint_map.yaml", floating));
}

inline std::optional<std::filesystem::path> sharedRobots() {
  const char* shared = std::getenv("ROBOTUI_SHARED");
  if (shared == nullptr) return {};
  return std::filesystem::path(shared) / "data" / "robots";
}

inline RobotPtr coman(const std::filesystem::path& robots) {
  const auto folder = robots / "coman_urdf";
  return std::make_shared<config::RobotDescription>(config::describe(
      folder / "urdf/coman.urdf", folder / "srdf/coman.srdf", folder / "config/coman_joint_map.yaml", true));
}

// The Panda comes without a joint map.
inline RobotPtr panda(const std::filesystem::path& robots) {
  std::string pattern = (std::filesystem::temp_directory_path() / "rt-panda-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  const std::filesystem::path map = std::filesystem::path(pattern) / "map.yaml";
  std::ofstream(map) << "joint_map: {1: panda_joint1, 2: panda_joint2, 3: panda_joint3, 4: panda_joint4, 5: "
                        "panda_joint5, 6: panda_joint6, 7: panda_joint7}\n";
  const auto folder = robots / "panda_description";
  auto robot = std::make_shared<config::RobotDescription>(
      config::describe(folder / "urdf/panda.urdf", folder / "srdf/panda.srdf", map, false));
  std::filesystem::remove_all(pattern);
  return robot;
}

// By name: arm, humanoid, panda or coman; nothing where it is not here.
inline RobotPtr robotNamed(const std::string& name) {
  if (name == "arm") return ownRobot("arm", false);
  if (name == "humanoid") return ownRobot("humanoid", true);
  const auto robots = sharedRobots();
  if (!robots) return nullptr;
  return name == "panda" ? panda(*robots) : coman(*robots);
}

}  // namespace robotui::rt
