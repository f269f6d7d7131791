// What clients ask about the robot as a whole: its memory, and the texts that describe it.
#pragma once

#include <cstdint>
#include <string_view>

#include "robotui/rt/config/config.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/emergency_stops.h"
#include "robotui/rt/supervisor/hal_process.h"
#include "robotui/rt/supervisor/host_supervisor.h"

namespace robotui::rt::supervisor {

class RobotRequests {
 public:
  RobotRequests(const config::RobotDescription& robot, HalProcess& hal, const HostSupervisor& hosts,
                BoardPublisher& board, const EmergencyStops& stops, ClientReplies& replies)
      : robot_(robot), hal_(hal), hosts_(hosts), board_(board), stops_(stops), replies_(replies) {}

  void attach(std::uint64_t client);

  // A text of the robot in pieces, as packets are small: "urdf OFFSET" is answered by "ok NEXT PIECE", where NEXT is 0
  // at the end.
  void describe(std::uint64_t client, std::string_view words);

  // Bring back what of the hardware does not come back by itself. What becomes of it is said in the log.
  void recover(std::uint64_t client) { askHal(client, "recover"); }
  // Enable or disable the drives; they are not disabled while a plugin leads a joint.
  void enable(std::uint64_t client) { askHal(client, "enable"); }
  void disable(std::uint64_t client);
  // Where the drives stand: a line each, of phase, joint and detail.
  void drives(std::uint64_t client);

  // How the emergency stops stand: a line each, of state and name.
  void stops(std::uint64_t client);
  // Press or release one that is simulated: "1|0 NAME", or all without a name.
  void press(std::uint64_t client, std::string_view words);

 private:
  void askHal(std::uint64_t client, std::string_view what);
  std::string leader();

  const config::RobotDescription& robot_;
  HalProcess& hal_;
  const HostSupervisor& hosts_;
  BoardPublisher& board_;
  const EmergencyStops& stops_;
  ClientReplies& replies_;
};

}  // namespace robotui::rt::supervisor
