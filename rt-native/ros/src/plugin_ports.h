// The topics, services and parameters that plugins have announced, offered to ROS for as long as those plugins live.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ros/callback_queue.h>

#include "log_function.h"
#include "robotui/rt/config/plan.h"
#include "robotui/rt/ros/announcement.h"

namespace robotui::rt::ros_bridge {

// One topic, service or set of parameters of one plugin.
class Port {
 public:
  virtual ~Port() = default;
  virtual void turn() {}  // takes what the plugin has written
};

// Where a port is and what it may use.
struct PortPlace {
  ChannelDirectory& channels;
  std::string plugin;
  std::size_t index;
  ::ros::CallbackQueue& queue;  // served by threads of their own
  const LogFunction& log;
  std::string inName() const { return ros::channelName(plugin, index, true); }
  std::string outName() const { return ros::channelName(plugin, index, false); }
  std::string topic(const std::string& name) const;
};

// Throws where ROS or the channels refuse it.
std::unique_ptr<Port> makePort(const ros::Announcement& announcement, const PortPlace& place);

class PluginPorts {
 public:
  // Without channels (nobody started us) there are none. They outlive it.
  PluginPorts(ChannelDirectory* channels, const config::Plan& plan, ::ros::CallbackQueue& queue, LogFunction log);

  void turn();

 private:
  using Reader = ChannelReader<ros::AnnouncedPacket>;
  struct Place {
    Reader reader;
    std::uint64_t generation = 0;
    std::unique_ptr<Port> port;
  };
  void look();
  bool look(const std::string& plugin, std::vector<Place>& places, std::size_t index);
  bool refuse(const std::string& objection);
  void offer(const std::string& plugin, Place& place, std::size_t index, const ros::Announcement& announcement);

  ChannelDirectory* channels_;
  std::map<std::string, std::vector<Place>> plugins_;
  ::ros::CallbackQueue& queue_;
  LogFunction log_;
  std::unique_ptr<ros::AnnouncedPacket> packet_ = std::make_unique<ros::AnnouncedPacket>();
  std::string refused_;
  std::int64_t looked_ns_ = 0;
};

}  // namespace robotui::rt::ros_bridge
