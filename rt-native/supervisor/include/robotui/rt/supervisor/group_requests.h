// Plugins that clients want started and stopped together: in one cycle of the control, or not at all. Hosts get their
// plugins ready, the HAL decides in a cycle, and the board follows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/link/group_order.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/emergency_stops.h"
#include "robotui/rt/supervisor/hal_process.h"
#include "robotui/rt/supervisor/host_supervisor.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/plugin_registry.h"

namespace robotui::rt::supervisor {

class GroupRequests {
 public:
  struct Deferred {
    std::uint64_t client;
    std::string words;
  };

  GroupRequests(const config::RtConfig& config, const config::Plan& plan, PluginRegistry& registry, HalProcess& hal,
                HostSupervisor& hosts, BoardPublisher& board, const EmergencyStops& stops, ClientReplies& replies,
                LogFile& log)
      : config_(config), plan_(plan), registry_(registry), hal_(hal), hosts_(hosts), board_(board), stops_(stops),
        replies_(replies), log_(log) {}

  // "P 1 Q 0 ..." and the name of a group of the configuration; answered when it is done, or cannot be.
  void switchPlugins(std::uint64_t client, std::string_view words);
  void switchGroup(std::uint64_t client, std::string_view name);
  // The groups of the configuration: a line each of name, what is started and what is stopped, with tabs between.
  void list(std::uint64_t client);

  // What the HAL said: the words of a link::GroupOutcome.
  void decided(std::string_view words);

  // Looks whether a plugin of the group failed, or its process died, or the HAL.
  void turn();

  // While a group is being switched no other plugin is started: the request waits, and comes back by takeDeferred().
  // One that stops a plugin of the group ends the group.
  bool defers(std::uint64_t client, std::string_view words, std::uint32_t plugin, bool start);
  std::vector<Deferred> takeDeferred();

 private:
  struct Group {
    std::uint32_t number = 0;
    std::uint64_t client = 0;
    PluginGroup plugins;
    std::string why;  // it is to be given up; empty: it is not
  };

  std::optional<PluginGroup> groupOf(std::uint64_t client, std::string_view words);
  void begin(std::uint64_t client, PluginGroup plugins);
  void leaveOutWhatIsSo(PluginGroup& plugins) const;
  std::string objection(const PluginGroup& plugins) const;
  std::string objectionToState(std::uint32_t plugin) const;
  std::uint64_t everyOf(std::uint32_t plugin) const;
  std::uint64_t commonPeriod(const PluginGroup& plugins) const;
  link::GroupOrder orderOf(const PluginGroup& plugins) const;
  void arm(const link::GroupOrder& order, const PluginGroup& plugins);
  void tellHost(std::uint32_t plugin, const std::string& words);
  void giveUp(const std::string& why);
  void done(const Group& group, std::uint64_t cycle);
  void undone(const Group& group, const std::string& why);
  std::string reasonOf(const Group& group, const link::GroupOutcome& outcome) const;
  std::string lost() const;

  const config::RtConfig& config_;
  const config::Plan& plan_;
  PluginRegistry& registry_;
  HalProcess& hal_;
  HostSupervisor& hosts_;
  BoardPublisher& board_;
  const EmergencyStops& stops_;
  ClientReplies& replies_;
  LogFile& log_;
  std::uint32_t next_ = 1;
  std::optional<Group> group_;
  std::vector<Deferred> deferred_;
};

}  // namespace robotui::rt::supervisor
