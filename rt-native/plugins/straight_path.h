// The way of a frame to a pose: straight, and not faster than is said.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace robotui::rt::plugins {

using Twist = Eigen::Matrix<double, 6, 1>;  // linear over angular

// The translation over the rotation vector from one pose to another, in the axes that both are given in.
Twist poseDifference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) noexcept;

struct SpeedLimits {
  double linear;   // m/s
  double angular;  // rad/s
};

class StraightPath {
 public:
  // Nothing is on the way any more.
  void rest(const Eigen::Isometry3d& at) noexcept { target_ = now_ = at; }

  // `pose` or `move` of X Y Z [ROLL PITCH YAW], m and rad: the target, or how far it is moved on. False where these are
  // no 3 or 6 numbers of a reasonable size.
  bool setTarget(const double* numbers, int count) noexcept;
  bool moveTarget(const double* numbers, int count) noexcept;

  // Moves on, and says with which velocity; waits for a frame that is far behind, which is its difference to now().
  Twist advance(const Twist& behind, const SpeedLimits& most, double period) noexcept;
  // The same with a given velocity and without a target.
  Twist follow(const Twist& behind, const Twist& velocity, double period) noexcept;

  const Eigen::Isometry3d& target() const noexcept { return target_; }
  // Where the frame should be now.
  const Eigen::Isometry3d& now() const noexcept { return now_; }

 private:
  void step(const Eigen::Vector3d& line, const Eigen::Vector3d& angle) noexcept;

  Eigen::Isometry3d target_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d now_ = Eigen::Isometry3d::Identity();
};

}  // namespace robotui::rt::plugins
