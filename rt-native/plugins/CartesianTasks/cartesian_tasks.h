// Several frames of a robot go to poses or move with velocities at once, in the order of their priority; the freedom
// that they leave brings the joints to a posture.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cartesian_task.h"
#include "moved_joints.h"
#include "part_distances.h"
#include "robotui/rt/link/fixed_text.h"
#include "robotui/rt/plugin/channel.h"
#include "robotui/rt/plugin/control_plugin.h"
#include "robotui/rt/plugin/task_report.h"
#include "task_parameters.h"

namespace robotui::rt::plugins {

// Parameters and what tasks do: docs/rt-cartesian.md. Commands: `pose TASK X Y Z [ROLL PITCH YAW]`, `move TASK DX DY DZ
// [DROLL DPITCH DYAW]`, `velocity TASK VX VY VZ [WX WY WZ]`, `posture [NAME]`, `enable TASK`, `disable TASK`, `stop
// [TASK]`.
class CartesianTasks final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  void on_stop(double time) noexcept override;
  bool on_command(std::string_view words) override;
  std::string_view status() const noexcept override { return status_.view(); }

 private:
  enum class Hindrance : std::uint8_t { kNone, kLimit, kSingular, kPriority, kDistance };

  struct Task {
    CartesianTask does;
    Hindrance hindrance = Hindrance::kNone;
    Eigen::Index which = 0;  // joint
    const PartDistances::Pair* pair = nullptr;
    Eigen::Index row = 0;  // of its level
  };

  void solveTasks(double period) noexcept;
  void solvePosture() noexcept;
  void begin(double period) noexcept;
  const PartDistances::Pair* findPair(const Task& task) const noexcept;
  void findHindrance(Task& task, const LevelOutcome& outcome, bool is_first) noexcept;
  void update() noexcept;
  void say() noexcept;
  void sayOf(const Task& task) noexcept;
  void sayNearest() noexcept;
  void openReport(Setup& setup);
  void report() noexcept;
  Task* findTask(std::string_view name) noexcept;
  bool obey(std::string_view verb, Task& task, std::string_view words) noexcept;
  bool setPosture(std::string_view name) noexcept;

  std::unique_ptr<ModelInterface> model_;
  std::optional<MovedJoints> joints_;
  std::vector<Task> tasks_;  // by priority
  std::optional<VelocityBounds> bounds_;
  std::optional<TaskHierarchy> hierarchy_;
  std::optional<PartDistances> distances_;
  std::optional<VelocityRows> approach_;  // of the nearest parts
  Eigen::MatrixXd rows_;                  // of a level
  Eigen::VectorXd wanted_;
  Eigen::MatrixXd each_joint_;
  Eigen::VectorXd posture_;
  std::string first_posture_;
  double posture_speed_ = 0.2;
  const config::RobotDescription* robot_ = nullptr;
  link::FixedText<240> status_;
  TaskReport report_{};
  ChannelWriter<TaskReport> reports_;
};

}  // namespace robotui::rt::plugins
