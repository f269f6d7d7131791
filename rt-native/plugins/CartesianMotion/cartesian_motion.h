// The tip of a chain goes to a pose with limited speed, the joints within their limits.
#pragma once

#include <memory>
#include <vector>

#include "chain_frame.h"
#include "robotui/rt/plugin/channel.h"
#include "robotui/rt/plugin/control_plugin.h"
#include "robotui/rt/plugin/task_report.h"
#include "straight_path.h"
#include "target_progress.h"

namespace robotui::rt::plugins {

// Parameters: `chain` (needed where the robot has several), `linear_speed` (m/s, default 0.1), `angular_speed` (rad/s,
// default 0.5), `damping` (of the least squares, default 0.02), `pose` ([x, y, z, roll, pitch, yaw] in m and rad in the
// frame of the chain's base link, to go to at the start). Commands: `pose X Y Z [ROLL PITCH YAW]`, `move DX DY DZ
// [DROLL DPITCH DYAW]` from where the tip is to go now, `stop`.
class CartesianMotion final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  void on_stop(double time) noexcept override;
  bool on_command(std::string_view words) override;
  std::string_view status() const noexcept override { return status_; }

 private:
  struct Moved {
    Joint* joint;
    int in_model;
    double position;  // of the reference
    double velocity;
    bool held;  // at its limit, in this cycle
  };

  void openReport(Setup& setup);
  void report() noexcept;
  void updateModel() noexcept;
  bool solve(const Twist& twist) noexcept;
  bool holdAtLimits(double period) noexcept;
  void limitVelocities() noexcept;
  void integrate(double period) noexcept;
  bool isThere() const noexcept;
  std::string_view statusNow(bool is_held) const noexcept;

  std::unique_ptr<ModelInterface> model_;
  ChainFrame chain_;
  std::vector<Moved> joints_;
  Eigen::VectorXd positions_;                       // of the model
  const ChainFrame::Jacobian* jacobian_ = nullptr;  // of this cycle
  SpeedLimits speeds_{0.1, 0.5};
  double damping_ = 0.02;
  std::vector<double> first_pose_;
  StraightPath path_;
  TargetProgress progress_;
  Eigen::Isometry3d at_ = Eigen::Isometry3d::Identity();
  std::string_view status_ = "stopped";
  TaskReport report_{};
  ChannelWriter<TaskReport> reports_;
};

}  // namespace robotui::rt::plugins
