// Capsules, and how far two of them are apart.
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "robotui/rt/robot/rigid_tree.h"

namespace robotui::rt::plugins {

// All points within `radius` of a segment; a sphere where its ends are one.
struct Capsule {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double radius;
};

struct CapsuleDistance {
  double metres;          // below zero where they overlap
  Eigen::Vector3d first;  // on the segment of each, where they are nearest
  Eigen::Vector3d second;
};

CapsuleDistance distanceBetween(const Capsule& first, const Capsule& second) noexcept;

// Capsules that cover the shape, and little more: a sphere and a cylinder one, a box several side by side. In the frame
// of its body. Not real time.
std::vector<Capsule> capsulesOf(const CollisionShape& shape);

}  // namespace robotui::rt::plugins
