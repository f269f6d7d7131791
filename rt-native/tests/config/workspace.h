// A folder of its own with the files of a small robot, for tests that change one of them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

inline const char* const kUrdf = R"(<?xml version="1.0"?>
<robot name="two">
  <link name="base"/>
  <link name="upper"><inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="lower"/>
  <link name="hand"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="2" velocity="3" effort="40"/></joint>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="lower"/><axis xyz="0 1 0"/>
    <limit velocity="4" effort="30"/></joint>
  <joint name="wrist_mount" type="fixed"><parent link="lower"/><child link="hand"/></joint>
</robot>
)";

inline const char* const kSrdf = R"(<?xml version="1.0"?>
<robot name="two">
  <group name="imu_sensors"><link name="base"/></group>
  <group name="force_torque_sensors"><joint name="wrist_mount"/></group>
  <group name="arm"><chain base_link="base" tip_link="hand"/></group>
  <group name="chains"><group name="arm"/></group>
  <group_state group="arm" name="home"><joint name="shoulder" value="0.5"/><joint name="elbow" value="-1"/></group_state>
</robot>
)";

inline const char* const kMap = "joint_map: {7: elbow, 3: shoulder}\n";

inline const char* const kConfig = R"(XBotInterface:
  urdf_path: robot.urdf
  srdf_path: robot.srdf
  joint_map_path: map.yaml
)";

class Workspace {
 public:
  Workspace() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rt-config-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    write("robot.urdf", kUrdf);
    write("robot.srdf", kSrdf);
    write("map.yaml", kMap);
    write("rt.yaml", kConfig);
  }
  ~Workspace() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }
  RtConfig load(const std::string& more = "", const Overrides& overrides = {}) const {
    write("rt.yaml", kConfig + more);
    return config::load(file("rt.yaml"), overrides);
  }
  // What the mistake of the configuration is said to be; the folder's name is taken out.
  std::string mistake(const std::string& more = "") const {
    try {
      load(more);
    } catch (const ConfigError& error) {
      std::string text = error.what();
      const std::string prefix = folder_.string() + "/";
      for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) text.erase(at, prefix.size());
      return text;
    }
    return "no mistake";
  }

 private:
  std::filesystem::path folder_;
};

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

}  // namespace robotui::rt::config
