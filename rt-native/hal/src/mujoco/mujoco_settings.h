// What HALInterface.params says to the simulation.
#pragma once

#include <string>

#include "robotui/rt/config/config.h"

namespace robotui::rt::hal {

struct MujocoSettings {
  int steps = 2;  // of the simulation in a period
  bool floor = true;
  bool fix_base = false;         // hang a robot with a floating base in the air
  double base_height = -1;       // m above the floor; below 0 is so that the lowest part stands on it
  std::string posture = "home";  // of the SRDF, in which it starts
  double drive_stiffness = 20;   // of joints in position mode, N m/rad for each N m of the joint's effort limit
  double drive_damping = 1;      // ratio; 1 is critical
  bool ignore_meshes = false;    // of <collision>: they touch nothing
  double armature = 0.001;  // inertia of motor and gear at the joint, kg m2 for each N m of the joint's effort limit
};

MujocoSettings readMujocoSettings(const config::HalConfig& config, const config::RobotDescription& robot,
                                  std::int64_t period_ns);

}  // namespace robotui::rt::hal
