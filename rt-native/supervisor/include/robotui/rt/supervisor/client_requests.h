// The requests of clients, each handed to whom it concerns.
#pragma once

#include <cstdint>

#include "robotui/rt/link/socket.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/group_requests.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/master_requests.h"
#include "robotui/rt/supervisor/plugin_requests.h"
#include "robotui/rt/supervisor/push_requests.h"
#include "robotui/rt/supervisor/robot_requests.h"

namespace robotui::rt::supervisor {

class ClientRequests {
 public:
  ClientRequests(PluginRequests& plugins, RobotRequests& robot, MasterRequests& master, PushRequests& pushes,
                 GroupRequests& groups, ClientReplies& replies, LogFile& log)
      : plugins_(plugins), robot_(robot), master_(master), pushes_(pushes), groups_(groups), replies_(replies),
        log_(log) {}

  // What cannot be done for one client (no descriptors are left) ends nothing.
  void serve(std::uint64_t client, const link::Packet& packet);

 private:
  void dispatch(std::uint64_t client, const link::Packet& packet);

  PluginRequests& plugins_;
  RobotRequests& robot_;
  MasterRequests& master_;
  PushRequests& pushes_;
  GroupRequests& groups_;
  ClientReplies& replies_;
  LogFile& log_;
};

}  // namespace robotui::rt::supervisor
