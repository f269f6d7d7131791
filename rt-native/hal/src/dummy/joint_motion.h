// One joint that moves as it is told, without a robot behind it.
#pragma once

#include "robotui/rt/config/config.h"
#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

// Positions are followed at the joint's velocity at most, velocities are integrated, efforts move an inertia with
// friction.
class JointMotion {
 public:
  JointMotion(const config::JointDescription& joint, double position) noexcept;

  void step(const Reference& reference, double seconds) noexcept;
  void measure(link::JointState& into) const noexcept;
  double position() const noexcept { return position_; }

 private:
  double wantedVelocity(const Reference& reference, double seconds) const noexcept;

  double lower_;
  double upper_;
  double fastest_;
  double position_;
  double velocity_ = 0;
  double effort_ = 0;
};

}  // namespace robotui::rt::hal
