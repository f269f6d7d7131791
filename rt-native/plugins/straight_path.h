// The way of a frame to a pose: straight, not faster than is said, and without a jump of the velocity.
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
  // Nothing is on the way any more, and nothing moves.
  void rest(const Eigen::Isometry3d& at) noexcept;
  // The frame is there now, and comes to rest as soon as it can.
  void stop(const Eigen::Isometry3d& at, const SpeedLimits& most) noexcept;

  // `pose` or `move` of X Y Z [ROLL PITCH YAW], m and rad: the target, or how far it is moved on. False where these are
  // no 3 or 6 numbers of a reasonable size.
  bool setTarget(const double* numbers, int count) noexcept;
  bool moveTarget(const double* numbers, int count) noexcept;

  // Moves on, and says with which velocity; waits for a frame that is far behind, which is its difference to now().
  // It takes 0.2 s from rest to the speeds, and hardly longer to come to rest again.
  Twist advance(const Twist& behind, const SpeedLimits& most, double period) noexcept;
  // The same with a given velocity and without a target.
  Twist follow(const Twist& behind, const Twist& velocity, const SpeedLimits& most, double period) noexcept;

  const Eigen::Isometry3d& target() const noexcept { return target_; }
  // Where the frame should be now.
  const Eigen::Isometry3d& now() const noexcept { return now_; }

 private:
  void step(const Twist& wanted, const SpeedLimits& most, double period) noexcept;
  void aimAtRest(const SpeedLimits& most) noexcept;

  Eigen::Isometry3d target_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d now_ = Eigen::Isometry3d::Identity();
  Twist velocity_ = Twist::Zero();
};

}  // namespace robotui::rt::plugins
