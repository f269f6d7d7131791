// What clients ask of plugins: start, stop, reload, a word, the status.
#pragma once

#include <cstdint>
#include <string_view>

#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/emergency_stops.h"
#include "robotui/rt/supervisor/group_requests.h"
#include "robotui/rt/supervisor/host_supervisor.h"
#include "robotui/rt/supervisor/pending_requests.h"
#include "robotui/rt/supervisor/plugin_registry.h"

namespace robotui::rt::supervisor {

class PluginRequests {
 public:
  PluginRequests(PluginRegistry& registry, HostSupervisor& hosts, PendingRequests& pending, BoardPublisher& board,
                 const EmergencyStops& stops, GroupRequests& groups, ClientReplies& replies)
      : registry_(registry), hosts_(hosts), pending_(pending), board_(board), stops_(stops), groups_(groups),
        replies_(replies) {}

  // `words` are those behind the verb. What the host has yet to do is answered later. "P 1|0", or several of it, which
  // are switched together.
  void switchPlugin(std::uint64_t client, std::string_view words);
  void reload(std::uint64_t client, std::string_view words);
  void command(std::uint64_t client, std::string_view words);
  void status(std::uint64_t client, std::string_view words);
  void trajectory(std::uint64_t client, std::string_view words);
  void tasks(std::uint64_t client, std::string_view words);

 private:
  void start(std::uint64_t client, std::uint32_t plugin);
  std::string objection(std::uint32_t plugin) const;
  void stop(std::uint64_t client, std::uint32_t plugin);
  HostProcess& hostOf(std::uint32_t plugin) { return hosts_[registry_.host(plugin)]; }

  PluginRegistry& registry_;
  HostSupervisor& hosts_;
  PendingRequests& pending_;
  BoardPublisher& board_;
  const EmergencyStops& stops_;
  GroupRequests& groups_;
  ClientReplies& replies_;
  std::uint32_t next_command_ = 1;
};

}  // namespace robotui::rt::supervisor
