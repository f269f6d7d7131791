// One thread of a host: woken by the robot's state, it runs its plugins in the order of the configuration and writes
// their commands.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>

#include "robotui/rt/host/hosted_plugin.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/command.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::host {

struct ThreadPlan {
  std::string name;
  std::uint32_t index;  // in its host
  std::int64_t period_ns;
  int priority;  // SCHED_FIFO; 0 is an ordinary thread, link::kByDeadline is SCHED_DEADLINE
  std::optional<int> core;
  bool runs_alone;     // also runs its plugins while the robot does not cycle: IO plugins
  double runtime = 0;  // share of the period, with SCHED_DEADLINE
};

// Applies priority and core to the calling thread. Empty, or a sentence why it could not be done.
std::string scheduleThisThread(const ThreadPlan& plan);

class PluginThread {
 public:
  PluginThread(ThreadPlan plan, const link::StateSegment& state, const link::BoardSegment& board,
               link::HostSegment& host);
  ~PluginThread();
  PluginThread(const PluginThread&) = delete;
  PluginThread& operator=(const PluginThread&) = delete;

  // Throws std::runtime_error with a sentence where the priority is not allowed.
  void start();
  void stop();

  const ThreadPlan& plan() const noexcept { return plan_; }
  // What its plugins sense: written by this thread alone.
  const link::FrameData& frame() const noexcept { return frame_; }

  // Plugins come and go while the thread cycles. detach() returns when the thread will not touch it again.
  void attach(HostedPlugin& plugin) noexcept;
  void detach(HostedPlugin& plugin) noexcept;

 private:
  void run() noexcept;
  void step(bool news) noexcept;
  void idle() noexcept;
  bool isDue() noexcept;
  bool runPlugin(HostedPlugin& plugin) noexcept;
  void collect(const HostedPlugin& plugin) noexcept;
  void account(std::int64_t begun, bool news) noexcept;
  link::ThreadStatistics& statistics() noexcept { return host_.thread_statistics[plan_.index]; }
  double time() const noexcept { return static_cast<double>(frame_.sensed_ns) * 1e-9; }

  const ThreadPlan plan_;
  const link::StateSegment& state_;
  link::HostSegment& host_;
  link::StateReader reader_;
  link::BoardReader board_;
  link::SlotWriter slot_;
  link::FrameData frame_{};
  link::CommandData commands_{};
  std::array<std::atomic<HostedPlugin*>, link::kMaxPlugins> plugins_{};
  std::atomic<bool> inside_{false};
  std::atomic<bool> stopping_{false};
  std::uint64_t due_ = 0;
  std::uint64_t every_ = 1;  // cycles of the HAL
  std::uint64_t last_cycle_ = 0;
  std::int64_t first_faults_ = -1;
  bool commanded_ = false;  // in the last cycle
  std::thread thread_;
};

}  // namespace robotui::rt::host
