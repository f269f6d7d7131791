// Joints as springs: they hold the position where they were, with a stiffness and damping, and give way.
#pragma once

#include <optional>
#include <vector>

#include "gravity_model.h"
#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

// Parameters: `joints` or `chains` (default: all joints), `stiffness` (N m/rad, default 100), `damping` (N m s/rad,
// default 10), `ramp` (seconds until the stiffness is whole, default 1), `gravity` (true: the model carries the weight,
// so that the springs need not). Commands: `stiffness 200`, `damping 5`.
class JointImpedance final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  void on_stop(double time) noexcept override;
  bool on_command(std::string_view words) override;
  std::string_view status() const noexcept override { return status_; }

 private:
  struct Spring {
    Joint* joint;
    double rest;
  };

  double approach(double value, double goal, double most, double period) const noexcept;

  RobotInterface* robot_ = nullptr;
  std::optional<GravityModel> gravity_;
  std::vector<Spring> springs_;
  double stiffness_goal_ = 100;
  double damping_goal_ = 10;
  double stiffness_ = 0;
  double damping_ = 0;
  double ramp_ = 1;
  std::string_view status_ = "stopped";
};

}  // namespace robotui::rt::plugins
