// The thread that cycles.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cycle.h"

namespace robotui::rt::hal {

struct LoopSettings {
  std::int64_t period_ns = 1'000'000;
  int priority = 90;   // 0 is an ordinary thread, link::kByDeadline is SCHED_DEADLINE
  double runtime = 0;  // share of the period, with SCHED_DEADLINE
  std::optional<int> core;
  bool allow_non_rt = false;
};

class Loop {
 public:
  Loop(Cycle& cycle, const LoopSettings& settings) : cycle_(&cycle), settings_(settings) {}
  ~Loop() { stop(); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  // Returns once the thread is set up. Throws std::runtime_error with the reason and the remedy where the system
  // refuses real time and that is not allowed; what it refused otherwise is returned.
  std::vector<std::string> start();

  // Makes all joints safe and ends when nothing moves any more, after a second at the latest.
  void stop() noexcept;

 private:
  std::vector<std::string> prepare() const;
  void cycle() noexcept;
  void once(std::uint64_t number, std::int64_t point_ns) noexcept;
  bool isDone(std::uint64_t number) noexcept;

  Cycle* cycle_;
  LoopSettings settings_;
  std::atomic<bool> stopping_{false};
  std::uint64_t stop_cycle_ = 0;
  std::int64_t last_start_ns_ = 0;
  std::thread thread_;
};

}  // namespace robotui::rt::hal
