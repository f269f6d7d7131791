// robotui-rt-ctl trajectory: a file of points for the plugin JointTrajectory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotui/rt/link/client.h"

namespace robotui::rt::supervisor {

// What the plugin is told, in its own words (JointTrajectory/joint_trajectory.h). Throws config::ConfigError with file,
// line and remedy.
std::vector<std::string> trajectoryWords(const std::filesystem::path& file);

// Tells the plugin, and waits until it has come to the end of it, or not: 0, or 1 after it said why.
int runTrajectory(link::Client& client, const std::string& plugin, const std::filesystem::path& file);

}  // namespace robotui::rt::supervisor
