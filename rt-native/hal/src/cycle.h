// One cycle of control: sense, publish, wake the plugins, take their commands, check them, move.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "command_inbox.h"
#include "group_switch.h"
#include "joint_control.h"
#include "joint_falls.h"
#include "robotui/rt/config/config.h"
#include "robotui/rt/hal/hal.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/state.h"
#include "safe_torque.h"
#include "stop_inputs.h"

namespace robotui::rt::hal {

struct CycleSettings {
  std::int64_t period_ns = 1'000'000;
  double deadline = 0.8;    // fraction of the period
  double safe_damping = 5;  // N m s/rad
  std::uint32_t misses_before_safe = 2;
  std::vector<double> following_errors = {};  // by joint, rad or m; those that are not there are not supervised
  std::uint64_t following_cycles = 500;       // in turn beyond that, and the joint falls
  std::size_t emergency_stops = 0;
};

class Cycle {
 public:
  // All that is given lives as long as the cycle.
  Cycle(const config::RobotDescription& robot, const CycleSettings& settings, Hal& hal, const link::BoardSegment& board,
        CommandInbox& inbox, SafeTorque& torque, link::StateSegment& state);

  // Its cycle numbers rise by one from 1; `start_ns` is the point of the grid from which the deadline counts. Real
  // time.
  void run(std::uint64_t cycle, std::int64_t start_ns) noexcept;

  // From any thread: nobody commands any more, all joints become safe.
  void end() noexcept { ending_.store(true, std::memory_order_relaxed); }

  // Whether after end() nothing is left that moves by a reference.
  bool isAtRest() const noexcept { return at_rest_.load(std::memory_order_relaxed); }

  link::LoopStatistics& statistics() noexcept { return writer_.loop(); }

  // On one ordinary thread: what there is to tell of joints. False where there is nothing more.
  bool takeEvent(link::JointEvent& into) noexcept { return falls_.take(into); }

  // Its ordinary part, on the same thread: groups of plugins to be switched.
  GroupSwitch& groups() noexcept { return groups_; }

  // On the same thread: which emergency stops keep the robot safe.
  StopReport takeStops() noexcept { return stops_.take(); }

 private:
  void sense(std::uint64_t cycle) noexcept;
  bool areNumbers() noexcept;
  Status shown(Status sensed) const noexcept;
  void anchor() noexcept;
  void keepOld() noexcept;
  void publish(std::uint64_t cycle) noexcept;
  void assign(std::uint64_t cycle) noexcept;
  void apply() noexcept;
  void follow() noexcept;
  bool obey(std::uint32_t joint) noexcept;
  bool obeyAnswer(std::uint32_t joint) noexcept;
  void fall(std::uint32_t joint, link::FallCause cause, double error = 0) noexcept;
  void fallTogether() noexcept;
  double safeEffort(std::uint32_t joint) const noexcept;
  void holdRest() noexcept;
  void move() noexcept;

  CycleSettings settings_;
  Hal* hal_;
  link::BoardReader board_;
  CommandInbox* inbox_;
  SafeTorque* torque_;
  link::StateWriter writer_;
  link::FrameData frame_{};
  link::FrameData last_good_{};
  Measurements measured_;
  std::vector<JointControl> joints_;
  JointFalls falls_;
  StopInputs stops_;
  GroupSwitch groups_;
  std::vector<std::uint64_t> astray_;  // cycles in turn too far from the reference, by joint
  std::vector<Reference> references_;
  std::vector<double> torques_;
  std::vector<bool> held_;
  std::uint32_t silent_ = 0;  // cycles in turn without measurements
  bool sensed_ = false;       // ever
  bool away_ = false;         // the hardware was silent so long that all joints were made safe
  std::atomic<bool> ending_{false};
  std::atomic<bool> at_rest_{false};
};

}  // namespace robotui::rt::hal
