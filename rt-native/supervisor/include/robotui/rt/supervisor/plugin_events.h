// What hosts say about their plugins, and what the death of a host means for them: states on the board, answers to
// requests, lines of the log.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "robotui/rt/link/socket.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/pending_requests.h"
#include "robotui/rt/supervisor/plugin_registry.h"

namespace robotui::rt::supervisor {

class PluginEvents {
 public:
  PluginEvents(PluginRegistry& registry, PendingRequests& pending, LogFile& log)
      : registry_(registry), pending_(pending), log_(log) {}

  // A message of this host; `socket` is the one to it.
  void handle(std::uint32_t host, const link::Packet& packet, const link::Socket& socket);

  // The host died: its plugins come back with it. The sentence is shown at those that were active or `at_work`.
  void hostDied(std::uint32_t host, const std::string& sentence, const std::set<std::uint32_t>& at_work);

  // It is not started any more, and its plugins have failed.
  void hostGivenUp(std::uint32_t host, const std::string& sentence);

  // By index on the board.
  std::string nameOf(std::uint32_t plugin) const { return plugin < registry_.size() ? registry_.name(plugin) : "?"; }

 private:
  void commandAnswered(std::uint32_t host, std::string_view id, bool understood);
  void loaded(std::uint32_t plugin, std::string_view role_and_joints, const link::Socket& socket);
  void started(std::uint32_t plugin);
  void stopped(std::uint32_t plugin);
  void failed(std::uint32_t plugin, std::string_view sentence);

  PluginRegistry& registry_;
  PendingRequests& pending_;
  LogFile& log_;
};

}  // namespace robotui::rt::supervisor
