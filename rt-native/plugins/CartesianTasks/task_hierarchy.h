// Joint velocities that do tasks in the order of their priority, as well as bounds allow. Nothing allocates after
// construction.
#pragma once

#include <Eigen/Dense>

#include "bounded_quadratic.h"

namespace robotui::rt::plugins {

// Of joint velocities. `reach` is what positions alone allow, and contains the others, which also keep limits of
// velocity and acceleration; a task that is too fast is slowed down, one that leaves its reach goes as near as it can.
struct VelocityBounds {
  explicit VelocityBounds(Eigen::Index joints);

  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  Eigen::VectorXd reach_lower;
  Eigen::VectorXd reach_upper;
};

// Of linear functions of the joint velocities: none may be below its bound. Where joints cannot stop at once, or the
// bound is above zero, it is kept as well as bounds of joints allow, before any level.
struct VelocityRows {
  VelocityRows(Eigen::Index most, Eigen::Index joints) : rows(most, joints), lower(most) {}

  Eigen::MatrixXd rows;  // the first `count` of them
  Eigen::VectorXd lower;
  Eigen::Index count = 0;
};

// What became of one level.
struct LevelOutcome {
  double scale = 1;        // of the velocity that the bounds of positions allow; below 1 it is slowed down
  double pivot = 0;        // the least in its rows within the freedom left to it: near zero it is near a singularity
  bool is_damped = false;  // for that reason
  bool is_lost = false;    // it has more rows than there is freedom left for
  bool is_done = true;     // the solver came to its minimum
};

// A cascade of least squares: each level moves in the null space of all before it, and so cannot disturb them. One
// cycle: begin(), solve() for each level from the first on, velocities().
class TaskHierarchy {
 public:
  using Index = Eigen::Index;

  // Sizes that no cycle exceeds: joints, rows of one level, other functions that are bounded.
  TaskHierarchy(Index joints, Index most_rows, Index most_others = 0);

  // The bounds live as long as the cycle.
  void begin(const VelocityBounds& bounds, const VelocityRows* others = nullptr) noexcept;

  // The next level: velocities for which `rows` * velocities is as near `wanted` as can be; its direction is kept where
  // `is_scaled`.
  LevelOutcome solve(const Eigen::Ref<const Eigen::MatrixXd>& rows, const Eigen::Ref<const Eigen::VectorXd>& wanted,
                     bool is_scaled) noexcept;

  const Eigen::VectorXd& velocities() const noexcept { return velocities_; }

 private:
  Index turn(Index rows, LevelOutcome& outcome) noexcept;
  void put(Index rows, double damping) noexcept;
  void restore() noexcept;
  void putBounds(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) noexcept;
  void slowDown(Index rows, double damping, LevelOutcome& outcome) noexcept;

  Index bounded() const noexcept { return velocities_.size() + (others_ == nullptr ? 0 : others_->count); }

  const VelocityBounds* bounds_ = nullptr;
  const VelocityRows* others_ = nullptr;
  BoundedQuadratic quadratic_;
  Eigen::VectorXd velocities_;
  Eigen::MatrixXd freedom_;    // orthonormal; its last free_ columns are what the levels so far leave
  Eigen::MatrixXd projected_;  // rows of the level in that freedom
  Eigen::VectorXd missing_;    // of what is wanted
  Eigen::VectorXd reached_;
  Eigen::VectorXd best_;
  Eigen::VectorXd reflection_;
  Eigen::VectorXd workspace_;
  Index free_ = 0;
};

}  // namespace robotui::rt::plugins
