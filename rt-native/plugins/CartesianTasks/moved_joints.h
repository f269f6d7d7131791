// The joints that tasks move: where their references are, and how fast they may go in the next cycle.
#pragma once

#include <utility>
#include <vector>

#include "robotui/rt/robot/model_interface.h"
#include "task_hierarchy.h"

namespace robotui::rt::plugins {

class MovedJoints {
 public:
  // All other joints of the robot stand in the model where they are held.
  MovedJoints(const std::vector<Joint*>& joints, RobotInterface& robot, ModelInterface& model);

  Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(joints_.size()); }
  // Their places in the model.
  std::vector<int> places() const;
  const Joint& joint(Eigen::Index i) const noexcept { return *joints_[static_cast<std::size_t>(i)].joint; }
  double position(Eigen::Index i) const noexcept { return joints_[static_cast<std::size_t>(i)].position; }

  // Of all joints of the model.
  const Eigen::VectorXd& all() const noexcept { return positions_; }

  // Where they are held, and in the model.
  void start(ModelInterface& model) noexcept;
  // By positions, velocities and accelerations.
  void bound(VelocityBounds& bounds, double period) const noexcept;
  // One cycle with these velocities.
  void move(const Eigen::VectorXd& velocities, double period, ModelInterface& model) noexcept;
  // Whether a velocity is as much as its position allows.
  bool isAtLimit(Eigen::Index i, double velocity, const VelocityBounds& bounds) const noexcept;

 private:
  struct Moved {
    Joint* joint;
    int in_model;
    double position;  // of the reference
    double velocity;
  };

  void update(ModelInterface& model) noexcept;

  std::vector<Moved> joints_;
  std::vector<std::pair<const Joint*, int>> others_;  // and where they are in the model
  Eigen::VectorXd positions_;                         // of the model
};

}  // namespace robotui::rt::plugins
