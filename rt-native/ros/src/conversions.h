// Between what lies in the link and messages of ROS.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <sensor_msgs/Imu.h>
#include <xbot_msgs/JointState.h>

#include "message_shape.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::ros_bridge {

// A name of a plugin or sensor as a part of a ROS name: what may not stand there becomes '_'.
std::string rosName(std::string_view name);

// Into a message that is used again: its arrays get their size once.
void fill(xbot_msgs::JointState& message, std::span<const std::string> names, std::span<const link::JointState> joints);

// Where they are not to be read back: no numbers.
void hideReferences(xbot_msgs::JointState& message);

void fill(sensor_msgs::Imu& message, const link::ImuState& imu);
void fill(geometry_msgs::WrenchStamped& message, const link::ForceTorqueState& sensor);

// What a JointCommand of any version says: `commands` has an element for each of `names`; joints that are not in it
// have mode 0. Empty, or why it says nothing.
std::string readCommand(const Columns& columns, std::span<const std::string> names,
                        std::vector<link::JointCommand>& commands);

}  // namespace robotui::rt::ros_bridge
