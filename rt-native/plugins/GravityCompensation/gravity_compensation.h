// Joints that float: efforts hold the robot's weight, a little damping calms it, and a hand can move it.
#pragma once

#include <optional>
#include <vector>

#include "gravity_model.h"
#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

// Parameters: `joints` or `chains` (default: all joints), `damping` (N m s/rad or N s/m, default 1).
class GravityCompensation final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  void on_stop(double time) noexcept override;
  std::string_view status() const noexcept override { return status_; }

 private:
  RobotInterface* robot_ = nullptr;
  std::optional<GravityModel> gravity_;
  std::vector<Joint*> joints_;
  double damping_ = 1;
  std::string_view status_ = "stopped";
};

}  // namespace robotui::rt::plugins
