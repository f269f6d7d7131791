// Robots in MuJoCo, built from their bodies: what the model and the simulation have in common. There where MuJoCo was
// found.
#pragma once

#include <functional>
#include <memory>

#include <mujoco/mujoco.h>

#include "robotui/rt/robot/rigid_tree.h"

namespace robotui::rt {

struct MujocoDelete {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
  void operator()(mjSpec* spec) const noexcept { mj_deleteSpec(spec); }
};
using MujocoModelPtr = std::unique_ptr<mjModel, MujocoDelete>;
using MujocoDataPtr = std::unique_ptr<mjData, MujocoDelete>;
using MujocoSpecPtr = std::unique_ptr<mjSpec, MujocoDelete>;

struct MujocoTree {
  MujocoSpecPtr spec;
  std::vector<mjsBody*> bodies;   // as in the tree
  std::vector<mjsJoint*> joints;  // as in the robot
};

// Bodies and joints with their names, angles in radians, nothing else. With `free_base` the base has a free joint.
MujocoTree addTree(const RigidTree& tree, const config::RobotDescription& robot, bool free_base);

// Throws std::runtime_error with MuJoCo's reason.
MujocoModelPtr compile(const MujocoTree& tree, const std::string& robot);
MujocoDataPtr makeData(const mjModel& model);

}  // namespace robotui::rt
