// robotui-rt: runs the HAL, the hosts and the ROS process, and serves clients, in turns of one ordinary thread. What is
// done in a turn is done by others; here is its order.
#pragma once

#include <string>
#include <vector>

#include "robotui/rt/supervisor/board_publisher.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/client_requests.h"
#include "robotui/rt/supervisor/control_server.h"
#include "robotui/rt/supervisor/emergency_stops.h"
#include "robotui/rt/supervisor/group_requests.h"
#include "robotui/rt/supervisor/hal_supervisor.h"
#include "robotui/rt/supervisor/host_supervisor.h"
#include "robotui/rt/supervisor/joint_events.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/master.h"
#include "robotui/rt/supervisor/options.h"
#include "robotui/rt/supervisor/pending_requests.h"
#include "robotui/rt/supervisor/plugin_events.h"
#include "robotui/rt/supervisor/plugin_registry.h"
#include "robotui/rt/supervisor/ros_supervisor.h"
#include "robotui/rt/supervisor/signals.h"

namespace robotui::rt::supervisor {

class Supervisor {
 public:
  Supervisor(const Options& options, const config::RtConfig& config, const config::Plan& plan, bool real_time,
             ControlServer& server, LogFile& log);

  // Until a signal, or until there is no robot any more. The exit code.
  int run();

 private:
  void waitForSomething();
  void turn();
  void serveClients(std::int64_t now_ns);
  void end();

  ControlServer& server_;
  LogFile& log_;
  Signals signals_;

  // What is shared with other processes, and what is known about plugins and requests.
  BoardPublisher board_;
  PluginRegistry registry_;
  Master master_;
  HalProcess hal_process_;
  RosProcess ros_process_;
  ClientReplies replies_;
  PendingRequests pending_;
  EmergencyStops stops_;

  // What acts on it, each on a subject of its own.
  PushRequests pushes_;
  PluginEvents events_;
  HostSupervisor hosts_;
  GroupRequests groups_;
  JointEvents joint_events_;
  HalSupervisor hal_;
  RosSupervisor ros_;
  PluginRequests plugin_requests_;
  RobotRequests robot_requests_;
  MasterRequests master_requests_;
  ClientRequests requests_;

  bool serving_ = false;  // from when all hosts were ready, or given up, for the first time
  bool ending_ = false;
  int exit_code_ = 0;
};

}  // namespace robotui::rt::supervisor
