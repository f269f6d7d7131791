// The process that shows the robot in ROS: started, listened to, watched. Whatever becomes of it, the robot goes on.
#pragma once

#include <cstdint>

#include "robotui/rt/supervisor/host_supervisor.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/options.h"
#include "robotui/rt/supervisor/ros_process.h"

namespace robotui::rt::supervisor {

class RosSupervisor {
 public:
  RosSupervisor(const Options& options, RosProcess& ros, const HostSupervisor& hosts, LogFile& log)
      : options_(options), ros_(ros), hosts_(hosts), log_(log) {}

  // Once a turn of the supervisor; started first when clients are served.
  void turn(std::int64_t now_ns, bool serving);

 private:
  void spawn(std::int64_t now_ns);
  void receive();

  const Options& options_;
  RosProcess& ros_;
  const HostSupervisor& hosts_;
  LogFile& log_;
};

}  // namespace robotui::rt::supervisor
