#include "straight_path.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::plugins {
namespace {

constexpr double kFarLinear = 0.05;  // m behind the path from which on the path waits for the frame
constexpr double kFarAngular = 0.2;  // rad
constexpr double kMostMetres = 100;
constexpr double kSpeedingUp = 0.2;  // s
constexpr double kBraking = 0.9;     // of the acceleration: the rest of it corrects the direction

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

Eigen::Matrix3d turned(const Eigen::Matrix3d& orientation, const Eigen::Vector3d& angle) noexcept {
  if (angle.norm() <= 0) return orientation;
  const Eigen::Matrix3d result = Eigen::AngleAxisd(angle.norm(), angle.normalized()) * orientation;
  return Eigen::Quaterniond(result).normalized().toRotationMatrix();
}

// The speed from which the path still comes to rest within `way`, cycle by cycle.
double slowed(double most, double way, double period) noexcept {
  const double braking = kBraking * most / kSpeedingUp;
  const double half = braking * period / 2;
  return std::min(most, std::sqrt(half * half + 2 * braking * way) - half);
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
    const Eigen::Matrix3d result = rotation(numbers[3], numbers[4], numbers[5]) * target_.linear();
    target_.linear() = result;
  }
  return true;
}

void StraightPath::rest(const Eigen::Isometry3d& at) noexcept {
  target_ = now_ = at;
  velocity_.setZero();
}

void StraightPath::stop(const Eigen::Isometry3d& at, const SpeedLimits& most) noexcept {
  now_ = at;
  aimAtRest(most);
}

// The target is where braking ends.
void StraightPath::aimAtRest(const SpeedLimits& most) noexcept {
  const auto way = [](const auto& velocity, double speed) {
    return Eigen::Vector3d(velocity * (velocity.norm() / (2 * kBraking * speed / kSpeedingUp)));
  };
  const Eigen::Vector3d angle = way(velocity_.tail<3>(), most.angular);
  target_ = now_;
  target_.translation() += way(velocity_.head<3>(), most.linear);
  target_.linear() = turned(now_.linear(), angle);
}

void StraightPath::step(const Twist& wanted, const SpeedLimits& most, double period) noexcept {
  const Twist change = wanted - velocity_;
  const double part = std::min(fraction(change.head<3>().norm(), most.linear / kSpeedingUp * period),
                               fraction(change.tail<3>().norm(), most.angular / kSpeedingUp * period));
  velocity_ += part * change;
  now_.translation() += velocity_.head<3>() * period;
  now_.linear() = turned(now_.linear(), velocity_.tail<3>() * period);
}

Twist StraightPath::advance(const Twist& behind, const SpeedLimits& most, double period) noexcept {
  Twist wanted = poseDifference(now_, target_) / period;
  wanted *= std::min(fraction(wanted.head<3>().norm(), slowed(most.linear, wanted.head<3>().norm() * period, period)),
                     fraction(wanted.tail<3>().norm(), slowed(most.angular, wanted.tail<3>().norm() * period, period)));
  if (isFar(behind)) wanted.setZero();
  step(wanted, most, period);
  return velocity_;
}

Twist StraightPath::follow(const Twist& behind, const Twist& velocity, const SpeedLimits& most,
                           double period) noexcept {
  step(isFar(behind) ? Twist::Zero().eval() : velocity, most, period);
  aimAtRest(most);
  return velocity_;
}

}  // namespace robotui::rt::plugins
