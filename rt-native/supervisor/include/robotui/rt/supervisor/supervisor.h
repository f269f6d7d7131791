// robotui-rt: starts the HAL and the hosts, watches them, grants joints, and answers clients. One ordinary thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/supervisor/board_keeper.h"
#include "robotui/rt/supervisor/desk.h"
#include "robotui/rt/supervisor/hal_keeper.h"
#include "robotui/rt/supervisor/host_keeper.h"
#include "robotui/rt/supervisor/journal.h"
#include "robotui/rt/supervisor/master.h"
#include "robotui/rt/supervisor/options.h"
#include "robotui/rt/supervisor/pending.h"
#include "robotui/rt/supervisor/ros_keeper.h"
#include "robotui/rt/supervisor/roster.h"
#include "robotui/rt/supervisor/signals.h"

namespace robotui::rt::supervisor {

class Supervisor {
 public:
  Supervisor(const Options& options, const config::RtConfig& config, const config::Plan& plan, bool real_time, Desk& desk, Journal& journal);

  // Until a signal, or until there is no robot any more. The exit code.
  int run();

 private:
  // ---- processes (processes.cpp)
  void spawnHal();
  void spawnHost(std::uint32_t host);
  void spawnHosts();
  void hearHal();
  void hearHost(std::uint32_t host);
  void hostSaid(std::uint32_t host, const link::Packet& packet);
  void pluginSaid(std::uint32_t plugin, std::string_view verb, std::string_view rest);
  void log(const std::string& whose, std::string_view words);
  void reapHal();
  void reapHost(std::uint32_t host);
  void hostDied(std::uint32_t host, const std::string& how);
  void respawn(std::int64_t now);
  void watch(std::int64_t now);
  bool areHostsSettled() const;

  // ---- the face in ROS (ros_process.cpp)
  void spawnRos(std::int64_t now);
  void hearRos();
  void keepRos(std::int64_t now);

  // ---- clients (requests.cpp)
  void serve(std::uint64_t client, const link::Packet& packet);
  void request(std::uint64_t client, const link::Packet& packet);
  void attach(std::uint64_t client);
  void switchPlugin(std::uint64_t client, std::string_view words);
  void start(std::uint64_t client, std::uint32_t plugin);
  void stop(std::uint64_t client, std::uint32_t plugin);
  void reload(std::uint64_t client, std::string_view words);
  void command(std::uint64_t client, std::string_view words);
  void status(std::uint64_t client, std::string_view words);
  void take(std::uint64_t client, std::string_view words);
  void describe(std::uint64_t client, std::string_view words);
  void reference(std::uint64_t client, std::string_view text);
  void reply(std::uint64_t client, const std::string& text);
  void answer(std::uint64_t client, const std::string& objection);
  void changed();

  // ---- the loop (supervisor.cpp)
  void waitForSomething();
  void turn();
  void end();
  void awaitEnd(std::int64_t patience_ns, const std::vector<Child*>& children);

  const Options& options_;
  const config::RtConfig& config_;
  const config::Plan& plan_;
  Desk& desk_;
  Journal& journal_;
  Signals signals_;
  BoardKeeper board_;
  Roster roster_;
  Master master_;
  Pending pending_;
  RosKeeper ros_;
  HalKeeper hal_;
  std::vector<std::unique_ptr<HostKeeper>> hosts_;
  std::uint32_t next_command_ = 1;
  std::int64_t reference_complaint_ns_ = 0;
  bool serving_ = false;
  bool ending_ = false;
  int exit_code_ = 0;
};

}  // namespace robotui::rt::supervisor
