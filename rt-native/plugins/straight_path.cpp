#include "straight_path.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::plugins {
namespace {

constexpr double kFarLinear = 0.05;  // m behind the path from which on the path waits for the frame
constexpr double kFarAngular = 0.2;  // rad
constexpr double kMostMetres = 100;

Eigen::Matrix3d rotation(double roll, double pitch, double yaw) noexcept {
  return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

// The rotation vector from one orientation to another, in the axes of the base.
Eigen::Vector3d turn(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) noexcept {
  const Eigen::AngleAxisd between(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
  return between.angle() * between.axis();
}

double fraction(double length, double most) noexcept { return length > most ? most / length : 1; }

bool areReasonable(const double* numbers, int count) noexcept {
  return (count == 3 || count == 6) &&
         std::all_of(numbers, numbers + count, [](double x) { return std::abs(x) <= kMostMetres; });
}

bool isFar(const Twist& behind) noexcept {
  return behind.head<3>().norm() > kFarLinear || behind.tail<3>().norm() > kFarAngular;
}

}  // namespace

Twist poseDifference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) noexcept {
  Twist result;
  result << to.translation() - from.translation(), turn(from, to);
  return result;
}

bool StraightPath::setTarget(const double* numbers, int count) noexcept {
  if (!areReasonable(numbers, count)) return false;
  target_.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  if (count == 6) target_.linear() = rotation(numbers[3], numbers[4], numbers[5]);
  return true;
}

bool StraightPath::moveTarget(const double* numbers, int count) noexcept {
  if (!areReasonable(numbers, count)) return false;
  target_.translation() += Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  if (count == 6) {
    const Eigen::Matrix3d turned = rotation(numbers[3], numbers[4], numbers[5]) * target_.linear();
    target_.linear() = turned;
  }
  return true;
}

void StraightPath::step(const Eigen::Vector3d& line, const Eigen::Vector3d& angle) noexcept {
  now_.translation() += line;
  if (angle.norm() > 0) {
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(angle.norm(), angle.normalized()) * now_.linear();
    now_.linear() = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  }
}

Twist StraightPath::advance(const Twist& behind, const SpeedLimits& most, double period) noexcept {
  if (isFar(behind)) return Twist::Zero();
  const Eigen::Vector3d line = target_.translation() - now_.translation();
  const Eigen::Vector3d rest = turn(now_, target_);
  const double part =
      std::min(fraction(line.norm(), most.linear * period), fraction(rest.norm(), most.angular * period));
  step(part * line, part * rest);
  Twist velocity;
  velocity << part * line / period, part * rest / period;
  return velocity;
}

Twist StraightPath::follow(const Twist& behind, const Twist& velocity, double period) noexcept {
  const bool waits = isFar(behind);
  if (!waits) step(velocity.head<3>() * period, velocity.tail<3>() * period);
  target_ = now_;
  return waits ? Twist::Zero() : velocity;
}

}  // namespace robotui::rt::plugins
