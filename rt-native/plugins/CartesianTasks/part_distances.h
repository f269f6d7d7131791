// Distances between parts of a robot, by capsules around the shapes of its URDF. Nothing allocates after construction.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"
#include "robotui/rt/robot/rigid_tree.h"
#include "task_hierarchy.h"

namespace robotui::rt::plugins {

// All points that are at most `radius` away from a line between two points.
struct Capsule {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double radius = 0;
};

// The least one of a few simple capsules around a shape, in the frame of the shape's body.
Capsule capsuleAround(const CollisionShape& shape);

struct DistanceParameters {
  double margin = 0.02;                              // m that pairs keep
  double influence = 0.1;                            // m above the margin from which on they approach more slowly
  std::vector<std::string> links;                    // that are looked at; empty is all
  std::vector<std::pair<std::string, Capsule>> own;  // in the frames of links, in place of their shapes
};

class PartDistances {
 public:
  static constexpr std::size_t kMostPairs = 1000;
  static constexpr Eigen::Index kMostRows = 40;  // of the nearest pairs, which bound the joints

  struct Pair {
    std::size_t a;  // capsules
    std::size_t b;
    double distance = 0;
    Eigen::Vector3d at_a = Eigen::Vector3d::Zero();
    Eigen::Vector3d at_b = Eigen::Vector3d::Zero();
  };

  // `joints`: those that move, by their index in the robot. Throws std::runtime_error where a link is not there,
  // nothing is left to look at, or there are too many pairs.
  PartDistances(const config::RobotDescription& robot, DistanceParameters parameters, std::vector<int> joints);

  // Where all joints of the robot are.
  void update(const Eigen::VectorXd& positions) noexcept;
  // What the nearest pairs allow.
  void put(VelocityRows& rows) noexcept;
  // The pair of a row of the last put().
  const Pair& pairOf(Eigen::Index row) const noexcept { return pairs_[near_[static_cast<std::size_t>(row)]]; }

  std::size_t size() const noexcept { return pairs_.size(); }
  const Pair& nearest() const noexcept { return pairs_[nearest_]; }
  const std::string& linkA(const Pair& pair) const noexcept { return parts_[pair.a].link; }
  const std::string& linkB(const Pair& pair) const noexcept { return parts_[pair.b].link; }
  // Links whose shapes are meshes: they are not looked at unless a capsule was given for them.
  const std::vector<std::string>& meshLinks() const noexcept { return mesh_links_; }
  // Pairs that are nearer than the margin always, or in a posture of the SRDF, and so left out.
  std::size_t alwaysNear() const noexcept { return always_near_; }

 private:
  struct Part {
    std::string link;
    int body;
    Capsule in_body;
    Capsule now;
  };

  void addParts(const RigidTree& tree);
  void addPairs(const config::RobotDescription& robot);
  bool isFreeToTouch(const config::RobotDescription& robot, const Part& a, const Part& b) const;
  bool isMovedBetween(int a, int b) const;
  void leaveOutAlwaysNear(const config::RobotDescription& robot);
  bool carries(int body, int other) const noexcept;
  double slope(const Pair& pair, const Eigen::Vector3d& direction, int joint_body) const noexcept;

  DistanceParameters parameters_;
  std::vector<RigidBody> bodies_;
  std::vector<Eigen::Isometry3d> places_;  // of the bodies, in the base
  std::vector<int> moved_;                 // the body of each joint that moves
  std::vector<Part> parts_;
  std::vector<Pair> pairs_;
  std::vector<std::string> mesh_links_;
  std::size_t always_near_ = 0;
  std::size_t nearest_ = 0;
  std::array<std::size_t, kMostRows> near_{};  // pairs, the nearest first
};

}  // namespace robotui::rt::plugins
