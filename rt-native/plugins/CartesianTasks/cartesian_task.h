// What one frame of the robot is to do, seen from another one: to be at a pose, or to move with a velocity.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robotui/rt/robot/model_interface.h"
#include "straight_path.h"
#include "target_progress.h"

namespace robotui::rt::plugins {

struct TaskDescription {
  std::string name;
  std::string link;
  std::string base;                                              // the link whose frame it is in
  int priority = 1;                                              // from 1, which comes first
  std::array<bool, 6> mask{true, true, true, true, true, true};  // x y z roll pitch yaw, about the axes of the base
  SpeedLimits speeds{0.1, 0.5};
  double timeout = 0.3;  // s after which a velocity ends that is not said again
  bool active = true;
};

class CartesianTask {
 public:
  // `joints`: those that move, by their places in the model. Throws std::runtime_error where a link is not there.
  CartesianTask(TaskDescription description, const ModelInterface& model, std::vector<int> joints);

  const TaskDescription& description() const noexcept { return description_; }
  bool isActive() const noexcept { return is_active_; }
  // One that begins anew stays where it is.
  void setActive(bool active) noexcept;

  // Looks where its frames are.
  void update(const ModelInterface& model) noexcept;
  // Stays where it is, from this cycle on.
  void rest() noexcept;
  // Brakes, and stays where it is then.
  void stop() noexcept;
  StraightPath& path() noexcept { return path_; }
  // Before another target is given to the path.
  void beginPath() noexcept;
  // In the axes of the base; within the limits of its speed.
  void setVelocity(const Twist& velocity) noexcept;

  // Of the velocities of the joints, as many as its mask has. put() moves the path on.
  Eigen::Index rows() const noexcept { return rows_; }
  void put(double period, Eigen::Ref<Eigen::MatrixXd> rows, Eigen::Ref<Eigen::VectorXd> wanted) noexcept;

  bool isThere() const noexcept;
  // It has not come nearer to its target for a second.
  bool isStuck() const noexcept { return !isLedByVelocity() && !isThere() && progress_.isStuck(); }
  bool isLedByVelocity() const noexcept { return seconds_left_ > 0; }
  // m and rad, of what its mask has.
  double metres() const noexcept { return toTarget().head<3>().norm(); }
  double radians() const noexcept { return toTarget().tail<3>().norm(); }

 private:
  Twist masked(Twist twist) const noexcept;
  Twist toTarget() const noexcept { return masked(poseDifference(at_, path_.target())); }

  TaskDescription description_;
  LinkId link_;
  LinkId base_;
  std::vector<int> joints_;
  Eigen::Index rows_ = 0;
  bool is_active_;
  StraightPath path_;
  TargetProgress progress_;
  Twist velocity_ = Twist::Zero();
  double seconds_left_ = 0;
  Eigen::Isometry3d at_ = Eigen::Isometry3d::Identity();
  Eigen::MatrixXd jacobian_;  // of the model
  Eigen::MatrixXd base_jacobian_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> relative_;  // of the joints, in the axes of the base
};

}  // namespace robotui::rt::plugins
