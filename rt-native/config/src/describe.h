// Where the three files of a robot were asked for, for errors.
#pragma once

#include "joint_limits.h"
#include "robotui/rt/config/config.h"
#include "urdf.h"

namespace robotui::rt::config {

struct RobotFile {
  std::filesystem::path file;  // empty where there is none
  Place wanted;
};

struct RobotFiles {
  RobotFile urdf;
  RobotFile srdf;
  RobotFile joint_map;
};

RobotDescription describe(const RobotFiles& files, const JointLimits& limits, bool floating_base,
                          NegativeInertia inertia, std::vector<std::string>& warnings);

}  // namespace robotui::rt::config
