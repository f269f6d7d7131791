#include "task_hierarchy.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::plugins {
namespace {

constexpr double kEndless = 1e9;       // m/s
constexpr double kNothing = 1e-9;      // a pivot that is no direction
constexpr double kSingular = 0.02;     // a pivot below which a level is damped
constexpr double kMostDamping = 0.02;  // at the singularity itself
constexpr double kLeastDamping = 1e-4;
constexpr double kSlowness = 0.01;  // how little a level gives of its direction to be faster: its weight
constexpr double kMissed = 1e-6;    // of what could be reached: less is rounding

double dampingFor(double pivot) noexcept {
  if (pivot >= kSingular) return kLeastDamping * kLeastDamping;
  const double near = 1 - (pivot / kSingular) * (pivot / kSingular);
  return kLeastDamping * kLeastDamping + kMostDamping * kMostDamping * near;
}

}  // namespace

VelocityBounds::VelocityBounds(Eigen::Index joints)
    : lower(Eigen::VectorXd::Zero(joints)), upper(lower), reach_lower(lower), reach_upper(lower) {}

TaskHierarchy::TaskHierarchy(Index joints, Index most_rows, Index most_others)
    : quadratic_(joints + 1, joints + most_others + 1), velocities_(Eigen::VectorXd::Zero(joints)),
      freedom_(joints, joints), projected_(std::max(most_rows, most_others), joints), missing_(projected_.rows()),
      reached_(most_rows), best_(joints), reflection_(joints), workspace_(std::max(joints, most_rows)) {}

void TaskHierarchy::begin(const VelocityBounds& bounds, const VelocityRows* others) noexcept {
  bounds_ = &bounds;
  others_ = others;
  velocities_ = bounds.lower.cwiseMax(bounds.upper.cwiseMin(0.0));
  freedom_.setIdentity();
  free_ = freedom_.cols();
  if (others_ != nullptr) restore();
}

// To stop each joint as fast as it can is not always best for a function of several: one that turns away is needed
// longer. The freedom of the levels stays whole.
void TaskHierarchy::restore() noexcept {
  Index count = 0;
  for (Index i = 0; i < others_->count; ++i) {
    const double lacking = others_->lower[i] - others_->rows.row(i).dot(velocities_);
    if (lacking <= kMissed) continue;
    projected_.row(count) = others_->rows.row(i);
    missing_[count++] = lacking;
  }
  if (count == 0) return;
  quadratic_.begin(free_, bounded());
  put(count, kLeastDamping * kLeastDamping);
  quadratic_.gradient().noalias() = -projected_.topRows(count).transpose() * missing_.head(count);
  putBounds(bounds_->lower, bounds_->upper);
  quadratic_.solve();
  velocities_ += quadratic_.variables();
  velocities_ = velocities_.cwiseMax(bounds_->lower).cwiseMin(bounds_->upper);
}

// Turns the freedom so that the rows, best first, lie in its first columns: how many they are.
TaskHierarchy::Index TaskHierarchy::turn(Index rows, LevelOutcome& outcome) noexcept {
  auto projected = projected_.topLeftCorner(rows, free_);
  auto freedom = freedom_.rightCols(free_);
  Index rank = 0;
  outcome.pivot = 0;
  for (; rank < std::min(rows, free_); ++rank) {
    const Index left = free_ - rank;
    Index best = 0;
    const double length = std::sqrt(projected.bottomRightCorner(rows, left).rowwise().squaredNorm().maxCoeff(&best));
    if (length <= kNothing) break;
    outcome.pivot = length;
    double tau = 0;
    double beta = 0;
    auto vector = reflection_.head(left);
    vector = projected.row(best).tail(left).transpose();
    vector.makeHouseholderInPlace(tau, beta);
    const auto essential = vector.tail(left - 1);
    projected.rightCols(left).applyHouseholderOnTheRight(essential, tau, workspace_.data());
    freedom.rightCols(left).applyHouseholderOnTheRight(essential, tau, workspace_.data());
  }
  if (rank < rows) outcome.is_lost = true;
  return rank;
}

void TaskHierarchy::put(Index rows, double damping) noexcept {
  const auto projected = projected_.topLeftCorner(rows, free_);
  auto hessian = quadratic_.hessian();
  hessian.topLeftCorner(free_, free_).noalias() = projected.transpose() * projected;
  hessian.diagonal().head(free_).array() += damping;
}

void TaskHierarchy::putBounds(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) noexcept {
  const Index joints = velocities_.size();
  quadratic_.rows().topLeftCorner(joints, free_) = freedom_.rightCols(free_);
  quadratic_.lower().head(joints) = (lower - velocities_).cwiseMin(0.0);
  quadratic_.upper().head(joints) = (upper - velocities_).cwiseMax(0.0);
  if (others_ == nullptr) return;
  const Index count = others_->count;
  const auto rows = others_->rows.topRows(count);
  quadratic_.rows().block(joints, 0, count, free_).noalias() = rows * freedom_.rightCols(free_);
  auto lower_of_others = quadratic_.lower().segment(joints, count);
  lower_of_others = others_->lower.head(count);
  lower_of_others.noalias() -= rows * velocities_;
  for (Index i = 0; i < count; ++i) lower_of_others[i] = std::min(lower_of_others[i], 0.0);
  quadratic_.upper().segment(joints, count).setConstant(kEndless);
}

LevelOutcome TaskHierarchy::solve(const Eigen::Ref<const Eigen::MatrixXd>& rows,
                                  const Eigen::Ref<const Eigen::VectorXd>& wanted, bool is_scaled) noexcept {
  LevelOutcome outcome;
  const Index count = rows.rows();
  if (count == 0) return outcome;
  outcome.is_lost = free_ == 0;
  if (free_ == 0) return outcome;
  projected_.topLeftCorner(count, free_).noalias() = rows * freedom_.rightCols(free_);
  missing_.head(count) = wanted;
  missing_.head(count).noalias() -= rows * velocities_;
  const Index rank = turn(count, outcome);
  const double damping = dampingFor(rank > 0 ? outcome.pivot : kSingular);
  outcome.is_damped = rank > 0 && outcome.pivot < kSingular;
  const auto projected = projected_.topLeftCorner(count, free_);
  quadratic_.begin(free_, bounded());
  put(count, damping);
  quadratic_.gradient().noalias() = -projected.transpose() * missing_.head(count);
  putBounds(bounds_->lower, bounds_->upper);
  outcome.is_done = quadratic_.solve();
  best_.head(free_) = quadratic_.variables();
  if (is_scaled) slowDown(count, damping, outcome);
  velocities_.noalias() += freedom_.rightCols(free_) * best_.head(free_);
  velocities_ = velocities_.cwiseMax(bounds_->lower).cwiseMin(bounds_->upper);
  free_ -= rank;
  return outcome;
}

// Where velocity and acceleration alone keep the level from what it could reach, it goes there in the same direction,
// as fast as it can: one more variable is the part of that velocity.
void TaskHierarchy::slowDown(Index rows, double damping, LevelOutcome& outcome) noexcept {
  const Index count = bounded();
  const auto projected = projected_.topLeftCorner(rows, free_);
  auto reached = reached_.head(rows);
  reached.noalias() = projected * best_.head(free_);
  if ((missing_.head(rows) - reached).norm() <= kMissed) return;
  quadratic_.begin(free_, count);
  put(rows, damping);
  quadratic_.gradient().noalias() = -projected.transpose() * missing_.head(rows);
  putBounds(bounds_->reach_lower, bounds_->reach_upper);
  outcome.is_done &= quadratic_.solve();
  auto reachable = missing_.head(rows);
  reachable.noalias() = projected * quadratic_.variables();
  const double length = reachable.norm();
  if ((reachable - reached).norm() <= kMissed + 1e-3 * length) return;
  quadratic_.begin(free_ + 1, count + 1);
  put(rows, kLeastDamping * kLeastDamping);  // what is reachable is damped already
  auto hessian = quadratic_.hessian();
  hessian.row(free_).head(free_).noalias() = -reachable.transpose() * projected;
  hessian(free_, free_) = length * length * (1 + kSlowness * kSlowness);
  quadratic_.gradient().setZero();
  quadratic_.gradient()[free_] = -length * length * kSlowness * kSlowness;
  quadratic_.rows().rightCols<1>().setZero();
  putBounds(bounds_->lower, bounds_->upper);
  quadratic_.rows().bottomRows<1>().setZero();
  quadratic_.rows()(count, free_) = 1;
  quadratic_.lower()[count] = 0;
  quadratic_.upper()[count] = 1;
  outcome.is_done &= quadratic_.solve();
  best_.head(free_) = quadratic_.variables().head(free_);
  outcome.scale = quadratic_.variables()[free_];
}

}  // namespace robotui::rt::plugins
