// The joints that can be commanded: ids to names.
#pragma once

#include "joint_limits.h"
#include "robotui/rt/config/config.h"
#include "urdf.h"

namespace robotui::rt::config {

// In the order of the ids. `wanted` is where the file was asked for.
std::vector<JointDescription> readJointMap(const std::filesystem::path& file, const Place& wanted, const Urdf& urdf,
                                           const JointLimits& limits);

}  // namespace robotui::rt::config
