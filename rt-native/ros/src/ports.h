// The kinds of ports.
#pragma once

#include "plugin_ports.h"

namespace robotui::rt::ros_bridge {

std::unique_ptr<Port> makePublishPort(const ros::Announcement& port, const PortPlace& place);
std::unique_ptr<Port> makeSubscribePort(const ros::Announcement& port, const PortPlace& place);
std::unique_ptr<Port> makeServePort(const ros::Announcement& port, const PortPlace& place);
std::unique_ptr<Port> makeTunePort(const ros::Announcement& port, const PortPlace& place);

}  // namespace robotui::rt::ros_bridge
