// What the HAL says of joints: a plugin whose joints are in their safe state is stopped, and all are told why and how
// to come back.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/link/joint_event.h"
#include "robotui/rt/supervisor/emergency_stops.h"
#include "robotui/rt/supervisor/host_supervisor.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/pending_requests.h"
#include "robotui/rt/supervisor/plugin_registry.h"

namespace robotui::rt::supervisor {

class JointEvents {
 public:
  JointEvents(const config::RtConfig& config, const config::Plan& plan, PluginRegistry& registry, HostSupervisor& hosts,
              PendingRequests& pending, const EmergencyStops& stops, LogFile& log)
      : config_(config), plan_(plan), registry_(registry), hosts_(hosts), pending_(pending), stops_(stops), log_(log) {}

  // `words` are those behind the verb.
  void handle(std::string_view words, std::int64_t now_ns);

  // What was heard is judged a little later: a plugin that failed, or whose process died, has said so then.
  void turn(std::int64_t now_ns);

 private:
  struct Fall {
    link::JointEvent event;
    std::int64_t due_ns;
  };
  void judge(const link::JointEvent& event);
  void stop(const link::JointEvent& event);
  std::string joint(std::uint16_t index) const;
  std::string causeOf(const link::JointEvent& event) const;
  std::string missed(const link::JointEvent& event) const;
  std::string slowest(std::uint32_t plugin) const;
  std::string fallen(const link::JointEvent& event) const;

  const config::RtConfig& config_;
  const config::Plan& plan_;
  PluginRegistry& registry_;
  HostSupervisor& hosts_;
  PendingRequests& pending_;
  const EmergencyStops& stops_;
  LogFile& log_;
  std::vector<Fall> falls_;
};

}  // namespace robotui::rt::supervisor
