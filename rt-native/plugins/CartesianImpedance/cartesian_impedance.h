// The tip of a chain as a spring in space: it holds a pose with a stiffness and damping of each axis, and gives way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chain_frame.h"
#include "gravity_model.h"
#include "robotui/rt/link/fixed_text.h"
#include "robotui/rt/plugin/control_plugin.h"
#include "straight_path.h"

namespace robotui::rt::plugins {

// Parameters: `chain` (needed where the robot has several), `stiffness` (of x, y, z in N/m and about x, y, z in N
// m/rad, default [500, 500, 500, 30, 30, 30]), `damping` (N s/m and N m s/rad, default [50, 50, 50, 3, 3, 3]), `axes`
// (`base` or `tip`: those that both count in, default base), `posture_damping` (N m s/rad, of motions of the joints
// that the tip does not feel, default 2), `effort` (fraction of the joints' limits that the spring may use together
// with the weight, default 0.8), `ramp` (seconds until another stiffness is whole, default 1), `linear_speed` (m/s,
// default 0.1), `angular_speed` (rad/s, default 0.5), `tolerance` (m and rad, default [0.01, 0.05]). Commands: `pose X
// Y Z [ROLL PITCH YAW]`, `move DX DY DZ [...]`, `stop`, `stiffness` and `damping` with 6 numbers. Poses are in the
// frame of the chain's base link, whose gravity is that of the model.
class CartesianImpedance final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  void on_stop(double time) noexcept override;
  bool on_command(std::string_view words) override;
  std::string_view status() const noexcept override { return status_.view(); }

 private:
  void approachGoal(double period) noexcept;
  Twist wrench(const Twist& error, const Twist& slower, const Eigen::Matrix3d& tip) const noexcept;
  void dampPosture(const ChainFrame::Jacobian& jacobian, const Twist& velocity) noexcept;
  double share(const Eigen::VectorXd& weight) const noexcept;
  void say(const Twist& error, const Twist& rest, bool is_limited) noexcept;

  RobotInterface* robot_ = nullptr;
  std::optional<GravityModel> gravity_;
  ChainFrame chain_;
  StraightPath path_;
  SpeedLimits speeds_{0.1, 0.5};
  Twist goal_{500, 500, 500, 30, 30, 30};
  Twist stiffness_{500, 500, 500, 30, 30, 30};
  Twist damping_{50, 50, 50, 3, 3, 3};
  bool in_axes_of_tip_ = false;
  double posture_damping_ = 2;
  double effort_ = 0.8;
  double ramp_ = 1;
  double linear_tolerance_ = 0.01;
  double angular_tolerance_ = 0.05;
  Eigen::VectorXd velocities_;
  Eigen::VectorXd efforts_;  // of the spring, without the weight
  link::FixedText<160> status_;
};

}  // namespace robotui::rt::plugins
