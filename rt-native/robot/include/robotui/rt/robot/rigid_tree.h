// A robot as the bodies between its commanded joints: what models and simulators are built from.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "robotui/rt/config/config.h"

namespace robotui::rt {

inline constexpr double kGravity = 9.81;  // m/s2

// All links that are fixed to each other, as one; a part of them where a simulator has to measure what is between.
struct RigidBody {
  std::string name;  // of the link that its joint carries
  int parent = -1;   // comes before it; -1 is the base
  int joint = -1;    // of the robot; -1 is the base, or a body that is fixed to its parent
  bool prismatic = false;
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  // in the parent's frame, its joint at zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();              // in its own frame
  double mass = 0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // at the center of mass
};

struct LinkFrame {
  int body;
  Eigen::Isometry3d in_body;
};

// A primitive of a <collision>.
struct CollisionShape {
  enum class Kind { kBox, kSphere, kCylinder } kind;
  int body;
  Eigen::Isometry3d in_body;
  std::string link;
  Eigen::Vector3d size;  // box: half sides; sphere: radius; cylinder: radius, half length along z
};

struct RigidTree {
  std::vector<RigidBody> bodies;           // parents first; the base is 0
  std::map<std::string, LinkFrame> links;  // of all links
  std::vector<CollisionShape> shapes;
  std::vector<std::string> mesh_links;  // whose <collision> has a mesh, which is left out; each once
  double mass() const;
};

// Throws std::runtime_error where the URDF cannot be read. Where its root is joined by a floating joint, what it
// carries is the base. The links of `apart` begin bodies of their own.
RigidTree buildRigidTree(const config::RobotDescription& robot, const std::set<std::string>& apart = {});

}  // namespace robotui::rt
