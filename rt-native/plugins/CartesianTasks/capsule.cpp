#include "capsule.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace robotui::rt::plugins {
namespace {

constexpr double kPoint = 1e-12;   // square of a length that is none
constexpr double kRounder = 1.15;  // radius of a capsule by that of the cylinder in it: rounder, but shorter
constexpr double kThin = 0.03;     // m of half a side that is covered by one row
constexpr double kMostInARow = 4;

// Covers what lies along the axis up to `half` on both sides, nowhere further from it than `radius`.
Capsule cover(const Eigen::Isometry3d& frame, const Eigen::Vector3d& middle, const Eigen::Vector3d& axis, double half,
              double radius) {
  const double round = kRounder * radius;
  const double end = std::max(half - std::sqrt(round * round - radius * radius), 0.0);
  const double most = end > 0 ? round : std::hypot(half, radius);
  return {frame * Eigen::Vector3d(middle - end * axis), frame * Eigen::Vector3d(middle + end * axis), most};
}

std::vector<Capsule> coverBox(const CollisionShape& box) {
  std::array<Eigen::Index, 3> sides{0, 1, 2};
  std::sort(sides.begin(), sides.end(), [&](auto a, auto b) { return box.size[a] > box.size[b]; });
  const double middle = box.size[sides[1]];
  const double thin = box.size[sides[2]];
  const double layers = thin > kThin ? 2 : 1;
  const double rows = std::clamp(std::ceil(middle * layers / std::max(thin, 1e-4)), 1.0, kMostInARow);
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(sides[0]);
  std::vector<Capsule> result;
  for (int row = 0; row < static_cast<int>(rows); ++row) {
    for (int layer = 0; layer < static_cast<int>(layers); ++layer) {
      Eigen::Vector3d at = Eigen::Vector3d::Zero();
      at[sides[1]] = middle * ((2 * row + 1) / rows - 1);
      at[sides[2]] = thin * ((2 * layer + 1) / layers - 1);
      result.push_back(cover(box.in_body, at, axis, box.size[sides[0]], std::hypot(middle / rows, thin / layers)));
    }
  }
  return result;
}

}  // namespace

// The nearest points of two segments: C. Ericson, Real-Time Collision Detection, 5.1.9.
CapsuleDistance distanceBetween(const Capsule& first, const Capsule& second) noexcept {
  const Eigen::Vector3d along = first.to - first.from;
  const Eigen::Vector3d other = second.to - second.from;
  const Eigen::Vector3d between = first.from - second.from;
  const double a = along.squaredNorm();
  const double e = other.squaredNorm();
  const double b = along.dot(other);
  const double c = along.dot(between);
  const double f = other.dot(between);
  const double square = a * e - b * b;
  double s = 0;
  if (a > kPoint) s = square > kPoint * a * e ? (b * f - c * e) / square : -c / a;
  s = std::clamp(s, 0.0, 1.0);
  double t = e > kPoint ? (b * s + f) / e : 0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > kPoint ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0;
  }
  CapsuleDistance result{0, first.from + s * along, second.from + t * other};
  result.metres = (result.second - result.first).norm() - first.radius - second.radius;
  return result;
}

std::vector<Capsule> capsulesOf(const CollisionShape& shape) {
  const Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  switch (shape.kind) {
    case CollisionShape::Kind::kSphere:
      return {{shape.in_body.translation(), shape.in_body.translation(), shape.size.x()}};
    case CollisionShape::Kind::kCylinder:
      return {cover(shape.in_body, middle, Eigen::Vector3d::UnitZ(), shape.size.y(), shape.size.x())};
    case CollisionShape::Kind::kBox: break;
  }
  return coverBox(shape);
}

}  // namespace robotui::rt::plugins
