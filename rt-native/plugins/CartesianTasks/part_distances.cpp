#include "part_distances.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

namespace robotui::rt::plugins {
namespace {

constexpr double kGain = 5;         // 1/s: the most m/s for each m above the margin
constexpr double kApart = 0.01;     // m/s at most, with which parts go apart that are nearer than the margin
constexpr double kNothing = 1e-9;   // m
constexpr int kSamples = 200;       // postures in which pairs are looked at beforehand
constexpr double kAlways = 0.95;    // of them
constexpr double kEndless = 3.141;  // rad: the range of joints without one

// The points of two lines between two points each that are nearest to each other (Ericson, Real-Time Collision
// Detection, 5.1.9).
std::pair<double, double> nearestPoints(const Capsule& a, const Capsule& b) noexcept {
  const Eigen::Vector3d along_a = a.to - a.from;
  const Eigen::Vector3d along_b = b.to - b.from;
  const Eigen::Vector3d between = a.from - b.from;
  const double aa = along_a.squaredNorm();
  const double bb = along_b.squaredNorm();
  const double b_between = along_b.dot(between);
  if (aa <= kNothing && bb <= kNothing) return {0, 0};
  if (aa <= kNothing) return {0, std::clamp(b_between / bb, 0.0, 1.0)};
  const double a_between = along_a.dot(between);
  if (bb <= kNothing) return {std::clamp(-a_between / aa, 0.0, 1.0), 0};
  const double ab = along_a.dot(along_b);
  const double across = aa * bb - ab * ab;
  double s = across > kNothing * aa * bb ? std::clamp((ab * b_between - a_between * bb) / across, 0.0, 1.0) : 0.5;
  double t = (ab * s + b_between) / bb;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((ab * t - a_between) / aa, 0.0, 1.0);
  }
  return {s, t};
}

void look(const Capsule& a, const Capsule& b, PartDistances::Pair& pair) noexcept {
  const auto [s, t] = nearestPoints(a, b);
  pair.at_a = a.from + s * (a.to - a.from);
  pair.at_b = b.from + t * (b.to - b.from);
  pair.distance = (pair.at_b - pair.at_a).norm() - a.radius - b.radius;
}

Capsule placed(const Eigen::Isometry3d& at, const Capsule& capsule) noexcept {
  return {at * capsule.from, at * capsule.to, capsule.radius};
}

Capsule along(const Eigen::Isometry3d& at, const Eigen::Vector3d& half, double radius) {
  return placed(at, {-half, half, radius});
}

bool isIn(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Capsule capsuleAround(const CollisionShape& shape) {
  const Eigen::Vector3d& size = shape.size;
  if (shape.kind == CollisionShape::Kind::kSphere) return along(shape.in_body, Eigen::Vector3d::Zero(), size.x());
  if (shape.kind == CollisionShape::Kind::kCylinder) {
    const bool is_flat = size.y() < size.x();  // then a ball reaches less far than a capsule
    return is_flat ? along(shape.in_body, Eigen::Vector3d::Zero(), std::hypot(size.x(), size.y()))
                   : along(shape.in_body, size.y() * Eigen::Vector3d::UnitZ(), size.x());
  }
  Eigen::Index longest = 0;
  size.maxCoeff(&longest);
  Eigen::Vector3d others = size;
  others[longest] = 0;
  const double radius = others.norm();
  // The corners of the ends are on the ball that ends it, or within.
  return along(shape.in_body, size[longest] * Eigen::Vector3d::Unit(longest), radius);
}

PartDistances::PartDistances(const config::RobotDescription& robot, DistanceParameters parameters,
                             std::vector<int> joints)
    : parameters_(std::move(parameters)) {
  const RigidTree tree = buildRigidTree(robot);
  bodies_ = tree.bodies;
  places_.resize(bodies_.size(), Eigen::Isometry3d::Identity());
  for (const int joint : joints) {
    const auto body =
        std::find_if(bodies_.begin(), bodies_.end(), [joint](const RigidBody& each) { return each.joint == joint; });
    moved_.push_back(body == bodies_.end() ? -1 : static_cast<int>(body - bodies_.begin()));
  }
  addParts(tree);
  addPairs(robot);
  leaveOutAlwaysNear(robot);
  if (pairs_.empty()) throw std::runtime_error("no two parts of the robot have shapes whose distance could be kept");
  if (pairs_.size() > kMostPairs)
    throw std::runtime_error("the distances of " + std::to_string(pairs_.size()) + " pairs of parts are too many (" +
                             std::to_string(kMostPairs) + " at most): name the parts with `distance: {links: [...]}`");
}

void PartDistances::addParts(const RigidTree& tree) {
  const auto isWanted = [&](const std::string& link) {
    return parameters_.links.empty() || isIn(parameters_.links, link);
  };
  std::vector<std::string> given;
  for (const auto& [link, capsule] : parameters_.own) {
    const auto frame = tree.links.find(link);
    if (frame == tree.links.end()) throw std::runtime_error("the robot has no link '" + link + "'");
    parts_.push_back({link, frame->second.body, placed(frame->second.in_body, capsule), {}});
    given.push_back(link);
  }
  for (const CollisionShape& shape : tree.shapes) {
    if (isWanted(shape.link) && !isIn(given, shape.link))
      parts_.push_back({shape.link, shape.body, capsuleAround(shape), {}});
  }
  for (const std::string& link : tree.mesh_links) {
    if (isWanted(link) && !isIn(given, link)) mesh_links_.push_back(link);
  }
  for (const std::string& link : parameters_.links) {
    if (!tree.links.contains(link)) throw std::runtime_error("the robot has no link '" + link + "'");
  }
}

void PartDistances::addPairs(const config::RobotDescription& robot) {
  for (std::size_t a = 0; a < parts_.size(); ++a) {
    for (std::size_t b = a + 1; b < parts_.size(); ++b) {
      const int body_a = parts_[a].body;
      const int body_b = parts_[b].body;
      const auto parent = [this](int body) { return bodies_[static_cast<std::size_t>(body)].parent; };
      if (body_a == body_b || parent(body_a) == body_b || parent(body_b) == body_a) continue;
      if (isFreeToTouch(robot, parts_[a], parts_[b]) || !isMovedBetween(body_a, body_b)) continue;
      pairs_.push_back({a, b});
    }
  }
}

bool PartDistances::isFreeToTouch(const config::RobotDescription& robot, const Part& a, const Part& b) const {
  return std::any_of(robot.free_to_touch.begin(), robot.free_to_touch.end(), [&](const auto& pair) {
    return (pair.first == a.link && pair.second == b.link) || (pair.first == b.link && pair.second == a.link);
  });
}

bool PartDistances::carries(int body, int other) const noexcept {
  while (other > body) other = bodies_[static_cast<std::size_t>(other)].parent;
  return other == body;
}

bool PartDistances::isMovedBetween(int a, int b) const {
  return std::any_of(moved_.begin(), moved_.end(),
                     [&](int body) { return body >= 0 && carries(body, a) != carries(body, b); });
}

// Capsules are larger than what is in them: those of parts that lie near each other overlap always, or where the robot
// is meant to be.
void PartDistances::leaveOutAlwaysNear(const config::RobotDescription& robot) {
  std::mt19937 random(1);  // the same ones at each start
  std::vector<int> near(pairs_.size(), 0);
  Eigen::VectorXd positions(static_cast<Eigen::Index>(robot.joints.size()));
  for (int sample = 0; sample < kSamples; ++sample) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const double lower = std::max(robot.joints[i].lower, -kEndless);
      const double upper = std::min(robot.joints[i].upper, kEndless);
      const double part = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
      positions[static_cast<Eigen::Index>(i)] = lower + part * (upper - lower);
    }
    update(positions);
    for (std::size_t i = 0; i < pairs_.size(); ++i) near[i] += pairs_[i].distance < parameters_.margin ? 1 : 0;
  }
  for (const config::Posture& posture : robot.postures) {
    positions.setZero();
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      for (const auto& [joint, position] : posture.joints) {
        if (joint == robot.joints[i].name) positions[static_cast<Eigen::Index>(i)] = position;
      }
    }
    update(positions);
    for (std::size_t i = 0; i < pairs_.size(); ++i) near[i] += pairs_[i].distance < parameters_.margin ? kSamples : 0;
  }
  std::vector<Pair> kept;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (near[i] < kAlways * kSamples) kept.push_back(pairs_[i]);
  }
  always_near_ = pairs_.size() - kept.size();
  pairs_ = std::move(kept);
}

void PartDistances::update(const Eigen::VectorXd& positions) noexcept {
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    const RigidBody& body = bodies_[i];
    const double at = body.joint < 0 ? 0 : positions[body.joint];
    places_[i] = places_[static_cast<std::size_t>(body.parent)] * body.placement;
    if (body.prismatic)
      places_[i].translate(body.axis * at);
    else
      places_[i].rotate(Eigen::AngleAxisd(at, body.axis));
  }
  for (Part& part : parts_) part.now = placed(places_[static_cast<std::size_t>(part.body)], part.in_body);
  nearest_ = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    look(parts_[pairs_[i].a].now, parts_[pairs_[i].b].now, pairs_[i]);
    if (pairs_[i].distance < pairs_[nearest_].distance) nearest_ = i;
  }
}

void PartDistances::put(VelocityRows& rows) noexcept {
  rows.count = 0;
  const double reach = parameters_.margin + parameters_.influence;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].distance >= reach) continue;
    if (count == near_.size() && pairs_[i].distance >= pairs_[near_.back()].distance) continue;
    std::size_t at = count < near_.size() ? count++ : count - 1;
    for (; at > 0 && pairs_[near_[at - 1]].distance > pairs_[i].distance; --at) near_[at] = near_[at - 1];
    near_[at] = i;
  }
  for (; rows.count < static_cast<Eigen::Index>(count); ++rows.count) {
    const Pair& pair = pairOf(rows.count);
    const Eigen::Vector3d between = pair.at_b - pair.at_a;
    const double length = between.norm();
    const Eigen::Vector3d direction = length > kNothing ? Eigen::Vector3d(between / length) : Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < moved_.size(); ++i)
      rows.rows(rows.count, static_cast<Eigen::Index>(i)) = slope(pair, direction, moved_[i]);
    rows.lower[rows.count] = std::min(-kGain * (pair.distance - parameters_.margin), kApart);
  }
}

// How fast the distance grows with the joint of a body.
double PartDistances::slope(const Pair& pair, const Eigen::Vector3d& direction, int joint_body) const noexcept {
  if (joint_body < 0) return 0;
  const auto index = static_cast<std::size_t>(joint_body);
  const Eigen::Vector3d axis = places_[index].linear() * bodies_[index].axis;
  const auto speed = [&](const Eigen::Vector3d& point) -> double {
    if (bodies_[index].prismatic) return direction.dot(axis);
    return direction.dot(axis.cross(point - places_[index].translation()));
  };
  double sum = 0;
  if (carries(joint_body, parts_[pair.b].body)) sum += speed(pair.at_b);
  if (carries(joint_body, parts_[pair.a].body)) sum -= speed(pair.at_a);
  return sum;
}

}  // namespace robotui::rt::plugins
