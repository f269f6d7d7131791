#include "joint_path.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::plugins {
namespace {

constexpr int kLooks = 16;              // at a way between two points
constexpr double kBeyond = 1e-6;        // rad or m: rounding does not leave a range
constexpr double kLeastSeconds = 1e-9;  // between two points

Knot cubic(const Knot& from, const Knot& to, double t, double length) noexcept {
  const double way = to.position - from.position;
  const double c2 = (3 * way / length - 2 * from.velocity - to.velocity) / length;
  const double c3 = (from.velocity + to.velocity - 2 * way / length) / (length * length);
  return {from.position + t * (from.velocity + t * (c2 + t * c3)), from.velocity + t * (2 * c2 + t * 3 * c3),
          2 * c2 + 6 * c3 * t};
}

Knot quintic(const Knot& from, const Knot& to, double t, double length) noexcept {
  const double h = length;
  const double way = to.position - from.position;
  const double c2 = from.acceleration / 2;
  const double c3 =
      (20 * way - (8 * to.velocity + 12 * from.velocity) * h - (3 * from.acceleration - to.acceleration) * h * h) /
      (2 * h * h * h);
  const double c4 = (-30 * way + (14 * to.velocity + 16 * from.velocity) * h +
                     (3 * from.acceleration - 2 * to.acceleration) * h * h) /
                    (2 * h * h * h * h);
  const double c5 = (12 * way - 6 * (to.velocity + from.velocity) * h + (to.acceleration - from.acceleration) * h * h) /
                    (2 * h * h * h * h * h);
  return {from.position + t * (from.velocity + t * (c2 + t * (c3 + t * (c4 + t * c5)))),
          from.velocity + t * (2 * c2 + t * (3 * c3 + t * (4 * c4 + t * 5 * c5))),
          2 * c2 + t * (6 * c3 + t * (12 * c4 + t * 20 * c5))};
}

}  // namespace

JointPath::JointPath(std::size_t most_joints)
    : most_joints_(most_joints), times_(kMostPoints + 1), knots_((kMostPoints + 1) * most_joints) {
  joints_.reserve(most_joints);
}

void JointPath::clear() noexcept {
  joints_.clear();
  points_ = 0;
  times_[0] = 0;
  is_quintic_ = false;
}

bool JointPath::addJoint(std::size_t joint) noexcept {
  if (joints_.size() == most_joints_ || std::find(joints_.begin(), joints_.end(), joint) != joints_.end()) return false;
  joints_.push_back(joint);
  return true;
}

bool JointPath::addPoint(double time) noexcept {
  if (points_ == kMostPoints) return false;
  times_[++points_] = time;
  std::fill_n(knots_.begin() + static_cast<std::ptrdiff_t>(points_ * most_joints_), most_joints_, Knot{});
  return true;
}

void JointPath::addPointAlone(double time) noexcept {
  points_ = 0;
  is_quintic_ = false;
  addPoint(time);
}

void JointPath::complete(Given given) noexcept {
  is_quintic_ = given == Given::kAccelerations;
  if (given != Given::kPositions) return;
  for (std::size_t place = 0; place < joints_.size(); ++place) chooseVelocities(place);
}

// Of three points one behind the other the harmonic mean of the two slopes, and zero where the joint turns back
// (Fritsch and Butland): it never goes beyond them. The last one is the end, where it rests. The first has no slope
// before it: the start is not known yet.
void JointPath::chooseVelocities(std::size_t place) noexcept {
  for (std::size_t i = 2; i < points_; ++i) {
    const double before = (knotOf(i, place).position - knotOf(i - 1, place).position) /
                          std::max(times_[i] - times_[i - 1], kLeastSeconds);
    const double behind = (knotOf(i + 1, place).position - knotOf(i, place).position) /
                          std::max(times_[i + 1] - times_[i], kLeastSeconds);
    knots_[i * most_joints_ + place].velocity = before * behind > 0 ? 2 * before * behind / (before + behind) : 0;
  }
}

void JointPath::stretch(double factor) noexcept {
  for (std::size_t i = 1; i <= points_; ++i) {
    times_[i] *= factor;
    for (std::size_t place = 0; place < joints_.size(); ++place) {
      Knot& knot = knots_[i * most_joints_ + place];
      knot.velocity /= factor;
      knot.acceleration /= factor * factor;
    }
  }
}

Knot JointPath::at(double time, std::size_t place) const noexcept {
  if (time >= duration()) return {knotOf(points_, place).position, 0, 0};
  const auto end = times_.begin() + 1 + static_cast<std::ptrdiff_t>(points_);
  const auto next = std::upper_bound(times_.begin() + 1, end, std::max(time, 0.0));
  return between(static_cast<std::size_t>(next - times_.begin()), time, place);
}

Knot JointPath::between(std::size_t index, double time, std::size_t place) const noexcept {
  const double length = std::max(times_[index] - times_[index - 1], kLeastSeconds);
  const double t = std::clamp(time - times_[index - 1], 0.0, length);
  const Knot& from = knotOf(index - 1, place);
  const Knot& to = knotOf(index, place);
  return is_quintic_ ? quintic(from, to, t, length) : cubic(from, to, t, length);
}

JointPath::Need JointPath::need(std::size_t point, std::size_t place, const Bounds& bounds) const noexcept {
  Need need{0, false};
  const std::size_t index = point + 1;
  for (int i = 0; i <= kLooks; ++i) {
    const double time = times_[index - 1] + (times_[index] - times_[index - 1]) * i / kLooks;
    const Knot knot = between(index, time, place);
    need.velocity = std::max(need.velocity, std::abs(knot.velocity) / bounds.velocity);
    need.leaves = need.leaves || knot.position < bounds.lower - kBeyond || knot.position > bounds.upper + kBeyond;
  }
  return need;
}

}  // namespace robotui::rt::plugins
