// Tunable parameters as dynamic_reconfigure says them.
#pragma once

#include <vector>

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include "robotui/rt/ros/announcement.h"

namespace robotui::rt::ros_bridge {

// `values` are in the order of `entries`.
dynamic_reconfigure::Config configOf(const std::vector<ros::TunableEntry>& entries, const std::vector<double>& values);
dynamic_reconfigure::ConfigDescription descriptionOf(const std::vector<ros::TunableEntry>& entries);

// Changes what of `values` is named in `wanted`, within the limits.
void merge(const dynamic_reconfigure::Config& wanted, const std::vector<ros::TunableEntry>& entries,
           std::vector<double>& values);

}  // namespace robotui::rt::ros_bridge
