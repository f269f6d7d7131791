// The HAL's process: the ordinary thread, which obeys the supervisor.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "command_plan.h"
#include "wake_latency.h"
#include "loop.h"
#include "robotui/rt/config/config.h"
#include "robotui/rt/config/plan.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/link/socket.h"

namespace robotui::rt::hal {

struct ProcessOptions {
  std::filesystem::path config;
  config::Overrides overrides;
  config::Communication communication;
  bool allow_non_rt = false;
  bool nrt = false;  // in an ordinary thread, also where real time is allowed
};

class Process {
 public:
  // `begin` carries the board and the hosts. Opens the robot and begins to cycle; throws with a sentence.
  Process(const ProcessOptions& options, link::Packet begin);
  ~Process();

  link::Descriptor shareState() const { return state_.shareReadOnly(); }
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

  // Until the supervisor ends it, is gone, or `ended` is set: then the robot is safe and the hardware closed.
  void obey(const link::Socket& supervisor, const std::atomic<bool>& ended);

 private:
  void hosts(link::Packet& begin);
  void stayAwake(int most_us);
  bool replaceHost(link::Packet& packet);
  void tellDrives(const link::Socket& supervisor);
  void tellStops(const link::Socket& supervisor);
  void switchGroup(const link::Packet& packet);
  void push(std::string_view words, const link::Socket& supervisor);
  void press(std::string_view words, const link::Socket& supervisor);

  link::Segment<link::StateSegment> state_;
  link::Segment<const link::BoardSegment> board_;
  std::unique_ptr<Hal> hal_;
  std::unique_ptr<SafeTorque> torque_;
  Waiting waiting_;
  std::unique_ptr<CommandInbox> inbox_;
  std::unique_ptr<Cycle> cycle_;
  std::unique_ptr<Loop> loop_;
  std::unique_ptr<WakeLatency> wake_latency_;
  std::vector<std::string> warnings_;
  std::string told_drives_;
  link::StopBits told_stops_{};
};

}  // namespace robotui::rt::hal
