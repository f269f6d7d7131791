// The HAL: started with the memory of the hosts, listened to, watched, and started again when it died.
#pragma once

#include <cstdint>

#include "robotui/rt/config/config.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/emergency_stops.h"
#include "robotui/rt/supervisor/group_requests.h"
#include "robotui/rt/supervisor/hal_process.h"
#include "robotui/rt/supervisor/host_supervisor.h"
#include "robotui/rt/supervisor/joint_events.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/options.h"
#include "robotui/rt/supervisor/push_requests.h"

namespace robotui::rt::supervisor {

class HalSupervisor {
 public:
  HalSupervisor(const Options& options, const config::RtConfig& config, HalProcess& hal, BoardPublisher& board,
                HostSupervisor& hosts, JointEvents& joints, EmergencyStops& stops, PushRequests& pushes,
                GroupRequests& groups, ClientReplies& replies, LogFile& log)
      : options_(options), config_(config), hal_(hal), board_(board), hosts_(hosts), joints_(joints), stops_(stops),
        pushes_(pushes), groups_(groups), replies_(replies), log_(log) {}

  // Throws std::runtime_error.
  void spawn();

  // What it said, and whether it died. False where there is no robot any more: it died again and again, or before it
  // opened the robot while nobody was served yet (`serving`).
  bool turn(bool serving);

  void respawn(std::int64_t now_ns);
  void watch(std::int64_t now_ns) { hal_.watch(now_ns); }

 private:
  void receive();
  bool ended(const std::string& how, bool serving);

  const Options& options_;
  const config::RtConfig& config_;
  HalProcess& hal_;
  BoardPublisher& board_;
  HostSupervisor& hosts_;
  JointEvents& joints_;
  EmergencyStops& stops_;
  PushRequests& pushes_;
  GroupRequests& groups_;
  ClientReplies& replies_;
  LogFile& log_;
};

}  // namespace robotui::rt::supervisor
