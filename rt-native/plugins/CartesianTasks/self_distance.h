// How far the parts of a robot are from each other, and how fast they may come nearer.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "capsule.h"
#include "robotui/rt/robot/model_interface.h"
#include "task_hierarchy.h"

namespace robotui::rt::plugins {

struct DistanceLimits {
  double least = 0.02;  // m, to which parts may come near
  double slow = 0.1;    // m, from which on they are slowed down
};

// The parts are the bodies between joints, each as capsules of its primitives of <collision>. Two of them are a pair
// unless one carries the other, the SRDF has disabled their collisions, or they overlap in the posture of the model
// when pairs are looked for; one that is nearer there than the least distance may come half as near as it is.
class SelfDistance {
 public:
  static constexpr Eigen::Index kMostNear = 8;  // pairs that a cycle looks after, the nearest ones

  SelfDistance(const config::RobotDescription& robot, const ModelInterface& model, const DistanceLimits& limits);

  // Capsules in the frame of a link, for one whose <collision> has none. False where there is no such link.
  bool add(const std::string& link, const Capsule& capsule);
  // After all is added, with the model in a posture in which nothing collides. `joints` are the moved ones, by places
  // in the model: of parts that none of them moves against each other no pair is made.
  void findPairs(const ModelInterface& model, const std::vector<int>& joints);

  std::size_t pairs() const noexcept { return pairs_.size(); }

  // One row each for the pairs that are near.
  void constrain(const ModelInterface& model, TaskHierarchy& hierarchy) noexcept;
  // The pair of a row, by its place, or of the nearest one.
  std::pair<std::string_view, std::string_view> names(Eigen::Index row) const noexcept;
  double metres(Eigen::Index row) const noexcept { return near_[static_cast<std::size_t>(row)].distance.metres; }
  Eigen::Index rows() const noexcept { return near_count_; }
  // By how much each joint's velocity brings the two nearer.
  Eigen::RowVectorXd row(Eigen::Index row) const { return rows_.row(row); }

 private:
  struct Part {
    std::string name;
    LinkId link;
    int parent;
    int joint;
    std::vector<Capsule> capsules;  // in its frame
    std::vector<Capsule> now;       // in the world
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::MatrixXd jacobian;  // 6 x dofs
    bool is_fresh = false;     // the jacobian, in this cycle
  };

  struct Near {
    std::size_t pair = 0;
    CapsuleDistance distance{};
  };

  struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    double least = 0;
  };

  void update(const ModelInterface& model) noexcept;
  CapsuleDistance nearest(std::size_t a, std::size_t b) const noexcept;
  void keep(const Near& found) noexcept;
  bool isPair(std::size_t a, std::size_t b) const noexcept;
  std::vector<bool> movedBy(std::size_t part, const std::vector<int>& joints) const;
  Part& fresh(std::size_t part, const ModelInterface& model) noexcept;
  const Pair& ends(Eigen::Index row) const noexcept { return pairs_[near_[static_cast<std::size_t>(row)].pair]; }

  DistanceLimits limits_;
  std::map<std::string, LinkFrame> frames_;
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> disabled_;
  std::vector<Pair> pairs_;
  std::vector<int> joints_;
  std::array<Near, kMostNear> near_{};
  Eigen::Index near_count_ = 0;
  Eigen::MatrixXd rows_;
};

}  // namespace robotui::rt::plugins
