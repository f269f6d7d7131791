// A line for the log of the robot, from wherever it comes: level (info, warn, error) and text.
#pragma once

#include <functional>
#include <string>

namespace robotui::rt::ros_bridge {

using LogFunction = std::function<void(const char* level, const std::string& line)>;

}  // namespace robotui::rt::ros_bridge
