#include "self_distance.h"

#include <algorithm>
#include <limits>

namespace robotui::rt::plugins {
namespace {

constexpr double kGain = 4;         // 1/s: how fast two parts may come nearer, by the way that is left
constexpr double kTouching = 1e-9;  // m between segments that cross each other

}  // namespace

SelfDistance::SelfDistance(const config::RobotDescription& robot, const ModelInterface& model,
                           const DistanceLimits& limits)
    : limits_(limits) {
  const RigidTree tree = buildRigidTree(robot);
  frames_ = tree.links;
  for (const RigidBody& body : tree.bodies)
    parts_.push_back({body.name,
                      model.findLink(body.name),
                      body.parent,
                      body.joint,
                      {},
                      {},
                      Eigen::Vector3d::Zero(),
                      Eigen::MatrixXd::Zero(6, model.getDofs()),
                      false});
  for (const CollisionShape& shape : tree.shapes) {
    auto& into = parts_[static_cast<std::size_t>(shape.body)].capsules;
    for (const Capsule& capsule : capsulesOf(shape)) into.push_back(capsule);
  }
  for (const auto& [first, second] : config::disabledCollisions(robot)) {
    const auto a = frames_.find(first);
    const auto b = frames_.find(second);
    if (a == frames_.end() || b == frames_.end()) continue;
    disabled_.emplace_back(
        std::minmax(static_cast<std::size_t>(a->second.body), static_cast<std::size_t>(b->second.body)));
  }
}

bool SelfDistance::add(const std::string& link, const Capsule& capsule) {
  const auto found = frames_.find(link);
  if (found == frames_.end()) return false;
  const auto& [body, in_body] = found->second;
  parts_[static_cast<std::size_t>(body)].capsules.push_back(
      {in_body * capsule.from, in_body * capsule.to, capsule.radius});
  return true;
}

// Which of the joints are between a part and the base.
std::vector<bool> SelfDistance::movedBy(std::size_t part, const std::vector<int>& joints) const {
  std::vector<bool> moved(joints.size(), false);
  for (auto at = static_cast<int>(part); at >= 0; at = parts_[static_cast<std::size_t>(at)].parent) {
    const auto joint = std::find(joints.begin(), joints.end(), parts_[static_cast<std::size_t>(at)].joint);
    if (joint != joints.end()) moved[static_cast<std::size_t>(joint - joints.begin())] = true;
  }
  return moved;
}

bool SelfDistance::isPair(std::size_t a, std::size_t b) const noexcept {
  if (parts_[a].capsules.empty() || parts_[b].capsules.empty()) return false;
  if (parts_[b].parent == static_cast<int>(a)) return false;
  return std::find(disabled_.begin(), disabled_.end(), std::pair(a, b)) == disabled_.end();
}

void SelfDistance::findPairs(const ModelInterface& model, const std::vector<int>& joints) {
  for (Part& part : parts_) part.now = part.capsules;
  joints_ = joints;
  rows_.setZero(kMostNear, static_cast<Eigen::Index>(joints.size()));
  update(model);
  pairs_.clear();
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!isPair(a, b) || movedBy(a, joints) == movedBy(b, joints)) continue;
      const double metres = nearest(a, b).metres;
      if (metres > 0) pairs_.push_back({a, b, metres < limits_.least ? metres / 2 : limits_.least});
    }
  }
}

void SelfDistance::update(const ModelInterface& model) noexcept {
  Eigen::Isometry3d pose;
  for (Part& part : parts_) {
    part.is_fresh = false;
    if (part.now.empty()) continue;
    model.getPose(part.link, pose);
    part.origin = pose.translation();
    for (std::size_t i = 0; i < part.now.size(); ++i) {
      part.now[i].from = pose * part.capsules[i].from;
      part.now[i].to = pose * part.capsules[i].to;
    }
  }
}

CapsuleDistance SelfDistance::nearest(std::size_t a, std::size_t b) const noexcept {
  CapsuleDistance least{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const Capsule& first : parts_[a].now) {
    for (const Capsule& second : parts_[b].now) {
      const CapsuleDistance found = distanceBetween(first, second);
      if (found.metres < least.metres) least = found;
    }
  }
  return least;
}

// The nearest first.
void SelfDistance::keep(const Near& found) noexcept {
  if (near_count_ == kMostNear && found.distance.metres >= near_.back().distance.metres) return;
  auto place = static_cast<std::size_t>(near_count_ < kMostNear ? near_count_++ : kMostNear - 1);
  for (; place > 0 && near_[place - 1].distance.metres > found.distance.metres; --place)
    near_[place] = near_[place - 1];
  near_[place] = found;
}

SelfDistance::Part& SelfDistance::fresh(std::size_t part, const ModelInterface& model) noexcept {
  Part& found = parts_[part];
  if (!found.is_fresh) model.getJacobian(found.link, found.jacobian);
  found.is_fresh = true;
  return found;
}

void SelfDistance::constrain(const ModelInterface& model, TaskHierarchy& hierarchy) noexcept {
  update(model);
  near_count_ = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const CapsuleDistance distance = nearest(pairs_[i].first, pairs_[i].second);
    if (distance.metres < limits_.slow) keep({i, distance});
  }
  const Eigen::Index offset = model.getDofs() - model.getJointNum();
  for (Eigen::Index row = 0; row < near_count_; ++row) {
    const Pair& pair = ends(row);
    const Part& first = fresh(pair.first, model);
    const Part& second = fresh(pair.second, model);
    const CapsuleDistance& distance = near_[static_cast<std::size_t>(row)].distance;
    Eigen::Vector3d away = distance.second - distance.first;
    if (away.norm() < kTouching) away = second.origin - first.origin;
    away.normalize();
    const Eigen::Vector3d by_first = (distance.first - first.origin).cross(away);
    const Eigen::Vector3d by_second = (distance.second - second.origin).cross(away);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const Eigen::Index column = offset + joints_[i];
      rows_(row, static_cast<Eigen::Index>(i)) =
          away.dot(first.jacobian.col(column).head<3>() - second.jacobian.col(column).head<3>()) +
          by_first.dot(first.jacobian.col(column).tail<3>()) - by_second.dot(second.jacobian.col(column).tail<3>());
    }
    hierarchy.constrain(rows_.row(row), kGain * (distance.metres - pair.least));
  }
}

std::pair<std::string_view, std::string_view> SelfDistance::names(Eigen::Index row) const noexcept {
  const Pair& pair = ends(row);
  return {parts_[pair.first].name, parts_[pair.second].name};
}

}  // namespace robotui::rt::plugins
