// Which joints of a URDF can be commanded, by which limits, and how they lie one behind the other.
#pragma once

#include <string>
#include <vector>

#include "urdf.h"

namespace robotui::rt::config {

// The limits of one joint: those of the URDF, and where it has none those that were chosen.
struct DraftJoint {
  const UrdfJoint* joint;
  double velocity;
  double effort;
  double acceleration;
  double jerk;

  bool velocityIsChosen() const { return joint->velocity <= 0; }
  bool effortIsChosen() const { return joint->effort <= 0; }
  bool accelerationIsChosen() const { return joint->acceleration <= 0; }
  bool jerkIsChosen() const { return joint->jerk <= 0; }
};

// Joints without a branch between them.
struct DraftChain {
  std::string name;
  std::string base_link;
  std::string tip_link;
  std::size_t joints;
};

struct DraftJoints {
  std::vector<DraftJoint> joints;     // from the root down, branch by branch in the order of the file
  std::vector<DraftChain> chains;     // of two joints at least
  std::vector<std::string> left_out;  // sentences
};

DraftJoints draftJoints(const Urdf& urdf);

}  // namespace robotui::rt::config
