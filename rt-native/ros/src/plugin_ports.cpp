#include "plugin_ports.h"

#include "conversions.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::int64_t kLookEvery = 100 * link::kMillisecond;

}  // namespace

std::string PortPlace::topic(const std::string& name) const {
  if (name.starts_with('/')) return name;
  return "/xbotcore/" + rosName(plugin) + (name.empty() ? "" : "/" + name);
}

PluginPorts::PluginPorts(ChannelDirectory* channels, const config::Plan& plan, ::ros::CallbackQueue& queue,
                         LogFunction log)
    : channels_(channels), queue_(queue), log_(std::move(log)) {
  for (const auto& each : plan.plugins) plugins_[each.plugin.name];
}

void PluginPorts::turn() {
  if (channels_ == nullptr) return;
  if (const std::int64_t now = link::now(); now - looked_ns_ > kLookEvery) {
    looked_ns_ = now;
    look();
  }
  for (auto& [plugin, places] : plugins_) {
    for (Place& place : places) {
      if (place.port != nullptr) place.port->turn();
    }
  }
}

// Ports are announced from 0 on without a gap.
void PluginPorts::look() {
  for (auto& [plugin, places] : plugins_) {
    std::size_t index = 0;
    while (index < ros::kMostPorts && look(plugin, places, index)) ++index;
    if (index < places.size()) places.resize(index);
  }
}

bool PluginPorts::look(const std::string& plugin, std::vector<Place>& places, std::size_t index) {
  if (index == places.size()) {
    Reader reader(*channels_, ros::announcementName(plugin, index), OtherSchema::kAwait);
    if (!reader.isConnected()) return refuse(reader.objection());
    places.push_back({std::move(reader), 0, nullptr});
  }
  Place& place = places[index];
  if (!place.reader.latest(*packet_)) return place.reader.isConnected();
  try {
    const ros::Announcement announcement = ros::readAnnouncement(packet_->bytes());
    if (announcement.generation != place.generation) offer(plugin, place, index, announcement);
  } catch (const std::exception& e) {
    if (place.generation != 1)
      log_("warn", "the plugin " + plugin + " announced something that is no topic: " + e.what());
    place.generation = 1;
    place.port.reset();
  }
  return true;
}

// Says an objection once, not at every look.
bool PluginPorts::refuse(const std::string& objection) {
  if (!objection.empty() && objection != refused_) log_("warn", objection);
  if (!objection.empty()) refused_ = objection;
  return false;
}

void PluginPorts::offer(const std::string& plugin, Place& place, std::size_t index,
                        const ros::Announcement& announcement) {
  place.port.reset();
  place.generation = announcement.generation;
  const PortPlace where{*channels_, plugin, index, queue_, log_};
  try {
    place.port = makePort(announcement, where);
  } catch (const std::exception& e) {
    log_("error", "the plugin " + plugin + " cannot have " + where.topic(announcement.name) + ": " + e.what());
  }
}

}  // namespace robotui::rt::ros_bridge
