// Moves the robot to a posture of its SRDF, smoothly and within its velocity limits.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robotui/rt/link/fixed_text.h"
#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

// Parameters: `posture` (default home), `joints` or `chains` (default: all joints of the posture), `speed` (fraction of
// the velocity limits, default 0.3), `time` (seconds; never shorter than the limits allow), `tolerance` (rad or m,
// default 0.05: as near each joint must be, as it is measured, for the robot to be at home).
class Homing final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  std::string_view status() const noexcept override { return status_.view(); }

 private:
  struct Move {
    Joint* joint;
    double from;
    double to;
  };

  void sayWhereItIs() noexcept;

  std::vector<Move> moves_;
  double tolerance_ = 0.05;
  double speed_ = 0.3;
  double least_seconds_ = 0;
  double seconds_ = 0;
  double begun_ = 0;
  link::FixedText<128> status_;
};

}  // namespace robotui::rt::plugins
