// A robot with drives and sensors on a floor, as MuJoCo sees it.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "mujoco_settings.h"
#include "robotui/rt/robot/mujoco_tree.h"

namespace robotui::rt::hal {

struct MujocoJoint {
  int position;  // in qpos
  int dof;       // in qvel
  int actuator;
  double stiffness;  // of the drive
  double damping;
};

struct MujocoLink {
  int body;
  std::array<double, 3> at;  // its origin in the frame of the body
  bool is_fixed;             // to the world
};

struct MujocoWorld {
  std::vector<std::string> mesh_links;  // whose meshes touch nothing
  MujocoModelPtr model;
  MujocoDataPtr data;
  std::vector<MujocoJoint> joints;  // by index of the robot
  std::map<std::string, MujocoLink> links;
  std::vector<int> imus;           // in sensordata: orientation, angular velocity, acceleration
  std::vector<int> force_torques;  // in sensordata: force, torque
};

// In its posture, at rest, standing on the floor. Throws std::runtime_error, also where it would fall through the
// floor, since it has meshes.
MujocoWorld buildMujocoWorld(const config::RobotDescription& robot, const MujocoSettings& settings, double period);

}  // namespace robotui::rt::hal
