// The hosts: started with the memory that they share, listened to, watched, and started again when they died.
#pragma once

#include <poll.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robotui/rt/config/plan.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/hal_process.h"
#include "robotui/rt/supervisor/host_process.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/master.h"
#include "robotui/rt/supervisor/options.h"
#include "robotui/rt/supervisor/plugin_events.h"
#include "robotui/rt/supervisor/ros_process.h"

namespace robotui::rt::supervisor {

// Whose memory a host is given, beside that of the other hosts.
struct HostMemory {
  HalProcess& hal;
  BoardPublisher& board;
  const Master& master;
  const RosProcess& ros;
};

class HostSupervisor {
 public:
  HostSupervisor(const Options& options, const config::Plan& plan, HostMemory memory, PluginEvents& events,
                 ClientReplies& replies, LogFile& log);

  // Those that do not run, once the HAL cycles. Throws std::runtime_error.
  void spawnAll();

  // What they said, and who died since.
  void turn();

  // Those that died, as soon as they may be started again.
  void respawn(std::int64_t now_ns);

  // Ends those that are stuck.
  void watch(std::int64_t now_ns);

  // They are nothing without the HAL.
  void killAll();

  // Whether each was started, and is ready or not started any more.
  bool areSettled() const;

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(hosts_.size()); }
  HostProcess& operator[](std::uint32_t host) { return *hosts_[host]; }
  std::vector<link::Descriptor> shareSegments() const;
  std::vector<link::Descriptor> shareChannels() const;
  std::vector<Child*> running();

 private:
  void spawn(std::uint32_t host);
  void receive(std::uint32_t host);
  void handle(std::uint32_t host, const link::Packet& packet);
  void ended(std::uint32_t host, const std::string& how);

  const Options& options_;
  const config::Plan& plan_;
  HostMemory memory_;
  PluginEvents& events_;
  ClientReplies& replies_;
  LogFile& log_;
  std::vector<std::unique_ptr<HostProcess>> hosts_;
  bool spawned_ = false;
};

}  // namespace robotui::rt::supervisor
