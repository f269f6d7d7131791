#include "task_hierarchy.h"

#include <gtest/gtest.h>

#include <random>

#include "robotui/rt/link/allocations.h"

namespace robotui::rt::plugins {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Numbers {
  std::mt19937 random{4711};

  double one(double most) { return std::uniform_real_distribution<double>(-most, most)(random); }
  MatrixXd matrix(Index rows, Index columns) {
    return MatrixXd::NullaryExpr(rows, columns, [this] { return one(1); });
  }
  VectorXd vector(Index size, double most) {
    return VectorXd::NullaryExpr(size, [this, most] { return one(most); });
  }
};

VelocityBounds boundsOf(Index joints, double most) {
  VelocityBounds bounds(joints);
  bounds.upper.setConstant(most);
  bounds.lower.setConstant(-most);
  bounds.reach_upper = bounds.upper;
  bounds.reach_lower = bounds.lower;
  return bounds;
}

// All combinations of joints at their lower bound, at their upper one and between: the least squares of each, under the
// equations that levels before set. Slow and simple.
struct AllCombinations {
  const VelocityBounds& bounds;
  MatrixXd equations;
  VectorXd values;

  double best(const MatrixXd& rows, const VectorXd& wanted) const {
    double least = std::numeric_limits<double>::infinity();
    const auto joints = static_cast<int>(bounds.lower.size());
    const int combinations = static_cast<int>(std::pow(3, joints));
    for (int i = 0; i < combinations; ++i) {
      VectorXd at(joints);
      if (isSolved(i, rows, wanted, at)) least = std::min(least, (rows * at - wanted).norm());
    }
    return least;
  }

  bool isSolved(int combination, const MatrixXd& rows, const VectorXd& wanted, VectorXd& at) const {
    const Index joints = at.size();
    MatrixXd all(equations.rows() + joints, joints);
    VectorXd right(all.rows());
    Index count = equations.rows();
    all.topRows(count) = equations;
    right.head(count) = values;
    for (Index joint = 0; joint < joints; ++joint, combination /= 3) {
      if (combination % 3 == 1) continue;
      all.row(count) = VectorXd::Unit(joints, joint).transpose();
      right[count++] = combination % 3 == 0 ? bounds.lower[joint] : bounds.upper[joint];
    }
    MatrixXd system = MatrixXd::Zero(joints + count, joints + count);
    system.topLeftCorner(joints, joints) = rows.transpose() * rows + 1e-10 * MatrixXd::Identity(joints, joints);
    system.block(joints, 0, count, joints) = all.topRows(count);
    system.block(0, joints, joints, count) = all.topRows(count).transpose();
    VectorXd sides(joints + count);
    sides << rows.transpose() * wanted, right.head(count);
    const VectorXd solution = system.completeOrthogonalDecomposition().solve(sides);
    at = solution.head(joints);
    return (all.topRows(count) * at - right.head(count)).norm() < 1e-7 && ((at - bounds.upper).array() < 1e-7).all() &&
           ((bounds.lower - at).array() < 1e-7).all();
  }
};

TEST(TaskHierarchyTest, IsAsGoodAsTheBestOfAllCombinationsOfBounds) {
  Numbers numbers;
  int bounded = 0;
  int compared = 0;
  for (int i = 0; i < 30; ++i) {
    const Index joints = 3 + i % 3;
    VelocityBounds bounds = boundsOf(joints, 1);
    bounds.upper += numbers.vector(joints, 0.5);
    bounds.lower += numbers.vector(joints, 0.5);
    bounds.reach_upper = bounds.upper;
    bounds.reach_lower = bounds.lower;
    const MatrixXd first = numbers.matrix(2, joints);
    const MatrixXd second = numbers.matrix(3, joints);
    const VectorXd wanted = numbers.vector(2, 2);
    const VectorXd then = numbers.vector(3, 2);
    TaskHierarchy hierarchy(joints, 3);
    hierarchy.begin(bounds);
    const LevelOutcome above = hierarchy.solve(first, wanted, false);
    const LevelOutcome below = hierarchy.solve(second, then, false);
    EXPECT_TRUE(above.is_done && below.is_done) << i;
    if (above.is_damped || below.is_damped) continue;  // it is to be slower than the best then
    ++compared;
    const VectorXd& at = hierarchy.velocities();
    AllCombinations reference{bounds, MatrixXd(0, joints), VectorXd(0)};
    const double least = reference.best(first, wanted);
    EXPECT_NEAR((first * at - wanted).norm(), least, 2e-4) << i;
    reference.equations = first;
    reference.values = first * at;
    EXPECT_NEAR((second * at - then).norm(), reference.best(second, then), 2e-3) << i;
    bounded += least > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(compared, 10);
  EXPECT_GT(bounded, 2) << "the bounds were to matter";
}

TEST(TaskHierarchyTest, ALowerTaskNeverDisturbsAHigherOneAndBoundsAlwaysHold) {
  Numbers numbers;
  for (int i = 0; i < 60; ++i) {
    const Index joints = 7 + i % 9;
    const VelocityBounds bounds = boundsOf(joints, 0.2 + std::abs(numbers.one(1)));
    TaskHierarchy hierarchy(joints, joints);
    hierarchy.begin(bounds);
    MatrixXd above(0, joints);
    VectorXd kept(0);
    for (const Index rows : {Index(3), Index(2), Index(6), joints}) {
      MatrixXd level = numbers.matrix(rows, joints);
      if (i % 3 == 0 && rows > 2) level.row(2) = level.row(0) + level.row(1);
      hierarchy.solve(level, numbers.vector(rows, 3), i % 2 == 0);
      const VectorXd& at = hierarchy.velocities();
      if (above.rows() > 0) {
        EXPECT_LT((above * at - kept).cwiseAbs().maxCoeff(), 1e-6) << i;
      }
      EXPECT_TRUE((at.array() <= bounds.upper.array()).all() && (at.array() >= bounds.lower.array()).all());
      above.conservativeResize(above.rows() + rows, joints);
      above.bottomRows(rows) = level;
      kept = above * at;
    }
  }
}

TEST(TaskHierarchyTest, ATaskThatIsTooFastIsSlowedDownInItsDirection) {
  Numbers numbers;
  for (int i = 0; i < 50; ++i) {
    VelocityBounds bounds = boundsOf(7, 0.3);
    bounds.reach_upper.setConstant(100);
    bounds.reach_lower.setConstant(-100);
    const MatrixXd rows = numbers.matrix(3, 7);
    const VectorXd wanted = 5 * numbers.vector(3, 1).normalized();
    TaskHierarchy hierarchy(7, 3);
    hierarchy.begin(bounds);
    const LevelOutcome outcome = hierarchy.solve(rows, wanted, true);
    const VectorXd got = rows * hierarchy.velocities();
    EXPECT_LT(outcome.scale, 1);
    EXPECT_GT(got.norm(), 0.05) << i;
    EXPECT_LT((got.normalized() - wanted.normalized()).norm(), 0.01) << i;
  }
}

TEST(TaskHierarchyTest, GoesAsNearAsPositionsLetIt) {
  VelocityBounds bounds = boundsOf(2, 1);
  bounds.upper[0] = bounds.reach_upper[0] = 0;
  TaskHierarchy hierarchy(2, 2);
  hierarchy.begin(bounds);
  const LevelOutcome outcome = hierarchy.solve(MatrixXd::Identity(2, 2), Eigen::Vector2d(0.5, 0.5), true);
  EXPECT_NEAR(hierarchy.velocities()[0], 0, 1e-9);
  EXPECT_NEAR(hierarchy.velocities()[1], 0.5, 1e-4);
  EXPECT_NEAR(outcome.scale, 1, 1e-9);
}

TEST(TaskHierarchyTest, IsDampedNearASingularity) {
  const VelocityBounds bounds = boundsOf(3, 1e3);
  double fastest = 0;
  for (const double bend : {0.2, 0.04, 0.01, 1e-3, 1e-5, 1e-8, 1e-12, 0.0}) {
    MatrixXd stretched(2, 3);  // of a planar arm that is nearly straight
    stretched << -bend, -bend / 2, 0, 1, 0.6, 0.3;
    TaskHierarchy hierarchy(3, 2);
    hierarchy.begin(bounds);
    const LevelOutcome outcome = hierarchy.solve(stretched, Eigen::Vector2d(0.1, 0), true);
    fastest = std::max(fastest, hierarchy.velocities().norm());
    EXPECT_EQ(outcome.is_damped || outcome.is_lost, bend < 0.1) << bend;
  }
  EXPECT_LT(fastest, 10);
}

TEST(ZeroTaskHierarchyTest, AsksNothingOfTheHeapInACycle) {
  Numbers numbers;
  const VelocityBounds bounds = boundsOf(40, 0.1);
  const MatrixXd rows = numbers.matrix(12, 40);
  const VectorXd wanted = numbers.vector(12, 1);
  const MatrixXd posture = MatrixXd::Identity(40, 40);
  const VectorXd home = numbers.vector(40, 1);
  TaskHierarchy hierarchy(40, 40);
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    hierarchy.begin(bounds);
    hierarchy.solve(rows, wanted, true);
    hierarchy.solve(posture, home, false);
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

}  // namespace
}  // namespace robotui::rt::plugins
