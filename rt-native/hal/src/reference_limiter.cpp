#include "reference_limiter.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::hal {

namespace {

constexpr int kHalvings = 40;
constexpr std::uint32_t kMostCycles = 1000;  // between two words of a plugin that is followed evenly
constexpr double kSameTime = 1e-12;          // of the limits: rounding is not beyond them

// How far a motion goes until it has stopped, with the least time: the acceleration runs to -peak, stays, and runs back
// to zero. The velocity that is left when it has run out is not below zero.
double brakingWay(double v, double a, double most_a, double jerk) noexcept {
  const double peak = std::min(most_a, std::sqrt(std::max(0.0, jerk * v + a * a / 2)));
  const double t1 = std::max(0.0, (a + peak) / jerk);
  const double v1 = v + (a - jerk * t1 / 2) * t1;
  const double t3 = peak / jerk;
  const double t2 = peak > 0 ? std::max(0.0, (v1 - peak * t3 / 2) / peak) : 0;
  const double v2 = v1 - peak * t2;
  return (v + (a / 2 - jerk * t1 / 6) * t1) * t1 + (v1 - peak * t2 / 2) * t2 +
         (v2 - peak * t3 / 2 + jerk * t3 * t3 / 6) * t3;
}

double stoppingWay(double v, double a, double most_a, double jerk) noexcept {
  const double left = v + a * std::abs(a) / (2 * jerk);
  return left >= 0 ? brakingWay(v, a, most_a, jerk) : -brakingWay(-v, -a, most_a, jerk);
}

// The largest acceleration of a cycle after which the velocity need not go beyond `most`.
double mostFor(double v, double most, double jerk, double period) noexcept {
  const double room = most - v;
  if (room <= 0) return room / period;
  return jerk * (std::sqrt(period * period + 2 * room / jerk) - period);
}

}  // namespace

ReferenceLimiter::ReferenceLimiter(const config::JointDescription& joint, double period_s) noexcept
    : lower_(joint.lower), upper_(joint.upper), most_velocity_(joint.velocity),
      most_acceleration_(std::min(joint.acceleration, 2 * joint.velocity / period_s)),
      most_jerk_(std::min(joint.jerk, 2 * most_acceleration_ / period_s)), period_(period_s),
      is_active_(std::isfinite(joint.acceleration) || std::isfinite(joint.jerk)) {}

void ReferenceLimiter::reset(double position) noexcept {
  position_ = said_ = goal_ = position;
  velocity_ = acceleration_ = slope_ = 0;
  since_ = to_come_ = 0;
  is_exact_ = true;
}

double ReferenceLimiter::follow(double wanted, bool is_new) noexcept {
  const double before = goal_;
  goal_ = evenly(std::clamp(wanted, lower_, upper_), is_new);
  const double of_goal = (goal_ - before) / period_;
  const double goal_velocity = std::abs(of_goal) <= most_velocity_ ? of_goal : 0;
  const Range reach = reachable();
  const Range range = withinPositions(reach);
  const double exact = ((goal_ - position_) / period_ - velocity_) / period_;
  const double slack = kSameTime * most_acceleration_;
  const double step = most_jerk_ * period_;
  // What comes from elsewhere may stay there only where it has the velocity, too.
  const bool can_stay = is_exact_ || (std::abs(velocity_ + exact * period_ - goal_velocity) <= step * period_ / 2 &&
                                      std::abs(exact) <= step);
  // What comes to rest at the end of the range does not go beyond it.
  const bool rests = std::abs(velocity_ + exact * period_) <= step * period_ / 2 && std::abs(exact) <= step;
  const Range& allowed = rests ? reach : range;
  is_exact_ = can_stay && exact >= allowed.least - slack && exact <= allowed.most + slack;
  advance(is_exact_ ? exact : towards(goal_, goal_velocity, range));
  if (is_exact_) position_ = goal_;
  is_behind_ = std::abs(goal_ - position_) > most_velocity_ * period_;
  return position_;
}

double ReferenceLimiter::evenly(double wanted, bool is_new) noexcept {
  since_ = std::min(since_ + 1, kMostCycles);
  if (is_new) {
    to_come_ = since_;
    since_ = 0;
    said_ = wanted;
    slope_ = (said_ - goal_) / to_come_;
  }
  if (to_come_ <= 1) {
    to_come_ = 0;
    return said_;
  }
  --to_come_;
  return goal_ + slope_;
}

double ReferenceLimiter::brake() noexcept {
  said_ = goal_ = position_;
  since_ = to_come_ = 0;
  advance(toVelocity(0, reachable()));
  is_exact_ = isAtRest();
  goal_ = said_ = position_;
  return position_;
}

double ReferenceLimiter::followVelocity(double wanted) noexcept {
  const double goal = std::clamp(wanted, -most_velocity_, most_velocity_);
  advance(toVelocity(goal, reachable()));
  is_behind_ = std::abs(goal - velocity_) > most_acceleration_ * period_;
  return velocity_;
}

// By jerk, acceleration, and the velocity in which it would end. Where they contradict each other, it is the jerk that
// is kept.
ReferenceLimiter::Range ReferenceLimiter::reachable() const noexcept {
  const double step = most_jerk_ * period_;
  const Range by_jerk{acceleration_ - step, acceleration_ + step};
  const double most = std::min(most_acceleration_, mostFor(velocity_, most_velocity_, most_jerk_, period_));
  const double least = -std::min(most_acceleration_, mostFor(-velocity_, most_velocity_, most_jerk_, period_));
  return {std::clamp(least, by_jerk.least, by_jerk.most), std::clamp(most, by_jerk.least, by_jerk.most)};
}

// So that it can stop before the ends of the joint's range.
ReferenceLimiter::Range ReferenceLimiter::withinPositions(Range range) const noexcept {
  if (std::isfinite(upper_) && afterStop(range.most, upper_, 0) > 0) range.most = towards(upper_, 0, range);
  if (std::isfinite(lower_) && afterStop(range.least, lower_, 0) < 0) range.least = towards(lower_, 0, range);
  if (range.least > range.most) range.least = range.most = (range.least + range.most) / 2;
  return range;
}

// How far beyond the goal, which moves, it would stop after a cycle of this acceleration. It rises with it.
double ReferenceLimiter::afterStop(double acceleration, double goal, double goal_velocity) const noexcept {
  const double v = velocity_ + acceleration * period_;
  const double p = position_ + v * period_;
  return p - goal + stoppingWay(v - goal_velocity, acceleration, most_acceleration_, most_jerk_);
}

// With which it would stop at the goal, or the nearest to that.
double ReferenceLimiter::towards(double goal, double goal_velocity, Range range) const noexcept {
  if (afterStop(range.most, goal, goal_velocity) <= 0) return range.most;
  if (afterStop(range.least, goal, goal_velocity) >= 0) return range.least;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (range.least + range.most) / 2;
    (afterStop(middle, goal, goal_velocity) > 0 ? range.most : range.least) = middle;
  }
  return range.least;
}

double ReferenceLimiter::toVelocity(double wanted, Range range) const noexcept {
  const double exact = (wanted - velocity_) / period_;
  const double step = most_jerk_ * period_;
  if (std::abs(exact) <= step && exact >= range.least && exact <= range.most) return exact;
  const double most = mostFor(velocity_, wanted, most_jerk_, period_);
  const double least = -mostFor(-velocity_, -wanted, most_jerk_, period_);
  return std::clamp(exact > 0 ? most : least, range.least, range.most);
}

void ReferenceLimiter::advance(double acceleration) noexcept {
  acceleration_ = acceleration;
  velocity_ += acceleration * period_;
  position_ += velocity_ * period_;
}

}  // namespace robotui::rt::hal
