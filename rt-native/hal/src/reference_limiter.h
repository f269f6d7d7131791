// Leads the reference of one joint to where a plugin wants it, without more velocity, acceleration or jerk than the
// joint may have: docs/adr/0198-references-are-limited-in-jerk-by-a-filter-of-our-own.md.
#pragma once

#include <cstdint>

#include "robotui/rt/config/config.h"

namespace robotui::rt::hal {

// What is within the limits goes through as it is. Velocity, acceleration and jerk are those of the references: their
// differences from cycle to cycle. Real time: no call allocates or blocks, and each takes a bounded time.
class ReferenceLimiter {
 public:
  ReferenceLimiter(const config::JointDescription& joint, double period_s) noexcept;

  // False where the joint has neither a limit of acceleration nor one of jerk: then nothing of it is to be used.
  bool isActive() const noexcept { return is_active_; }

  void reset(double position) noexcept;  // at rest there

  // The next position. `is_new` where the plugin has said it since the last call: a plugin that speaks every few cycles
  // is followed evenly in between.
  double follow(double wanted, bool is_new) noexcept;
  // The next position on the shortest way to rest, also outside the limits of position.
  double brake() noexcept;

  // The next velocity, where it is velocities that lead.
  double followVelocity(double wanted) noexcept;

  // The last reference is further from what was wanted for that cycle than one cycle can take it. What follows more
  // closely is rounded off where it changes, as by any limit of jerk, and arrives; on an even way between two answers
  // of a plugin it is that way that counts.
  bool isBehind() const noexcept { return is_behind_; }

  double velocity() const noexcept { return velocity_; }
  bool isAtRest() const noexcept { return velocity_ == 0 && acceleration_ == 0; }

 private:
  // Accelerations of the next cycle.
  struct Range {
    double least;
    double most;
  };

  double evenly(double wanted, bool is_new) noexcept;
  Range reachable() const noexcept;
  Range withinPositions(Range range) const noexcept;
  double towards(double goal, double goal_velocity, Range range) const noexcept;
  double toVelocity(double wanted, Range range) const noexcept;
  double afterStop(double acceleration, double goal, double goal_velocity) const noexcept;
  void advance(double acceleration) noexcept;

  double lower_;
  double upper_;
  double most_velocity_;
  double most_acceleration_;
  double most_jerk_;
  double period_;
  bool is_active_;

  double position_ = 0;
  double velocity_ = 0;
  double acceleration_ = 0;
  bool is_behind_ = false;
  bool is_exact_ = true;  // the last reference was what was wanted

  double said_ = 0;            // by the plugin, last
  double goal_ = 0;            // of the last cycle, on the way to what was said
  double slope_ = 0;           // per cycle
  std::uint32_t since_ = 0;    // cycles since it said something
  std::uint32_t to_come_ = 0;  // cycles until goal_ is what was said
};

}  // namespace robotui::rt::hal
