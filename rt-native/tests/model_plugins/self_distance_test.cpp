#include "self_distance.h"

#include "fake_setup.h"

#include <random>

namespace robotui::rt::plugins {
namespace {

using Eigen::Vector3d;

double bySampling(const Capsule& a, const Capsule& b) {
  double least = 1e9;
  for (int i = 0; i <= 50; ++i) {
    for (int k = 0; k <= 50; ++k) {
      const Vector3d on_a = a.from + (a.to - a.from) * i / 50;
      const Vector3d on_b = b.from + (b.to - b.from) * k / 50;
      least = std::min(least, (on_a - on_b).norm());
    }
  }
  return least - a.radius - b.radius;
}

TEST(CapsuleTest, DistancesAreThoseOfTheNearestPoints) {
  std::mt19937 random(7);
  const auto point = [&] {
    std::uniform_real_distribution<double> one(-1, 1);
    return Vector3d(one(random), one(random), one(random));
  };
  for (int i = 0; i < 40; ++i) {
    Capsule a{point(), point(), 0.1};
    Capsule b{point(), point(), 0.05};
    if (i % 4 == 1) a.to = a.from;
    if (i % 4 == 2) b.to = b.from;
    if (i % 4 == 3) b.to = b.from + 0.5 * (a.to - a.from);
    const CapsuleDistance found = distanceBetween(a, b);
    const double sampled = bySampling(a, b);
    EXPECT_NEAR(found.metres, sampled, 0.03) << i;
    EXPECT_LE(found.metres, sampled + 1e-9) << i;
    EXPECT_NEAR((found.first - found.second).norm() - 0.15, found.metres, 1e-12) << i;
  }
}

bool isIn(const Vector3d& point, const std::vector<Capsule>& capsules) {
  return std::any_of(capsules.begin(), capsules.end(), [&](const Capsule& capsule) {
    return distanceBetween(capsule, {point, point, 0}).metres <= 1e-9;
  });
}

TEST(CapsuleTest, CoverBoxesAndCylinders) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translate(Vector3d(0.3, -0.2, 0.1));
  frame.rotate(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  for (const Vector3d& half : {Vector3d(0.085, 0.14, 0.13), Vector3d(0.2, 0.02, 0.2), Vector3d(0.01, 0.01, 0.4)}) {
    const auto box = capsulesOf({CollisionShape::Kind::kBox, 0, frame, half});
    const auto cylinder = capsulesOf({CollisionShape::Kind::kCylinder, 0, frame, Vector3d(half.x(), half.y(), 0)});
    EXPECT_LE(box.size(), 8U);
    for (int i = 0; i < 1000; ++i) {
      const Vector3d part(i / 100 % 10 / 4.5 - 1, i / 10 % 10 / 4.5 - 1, i % 10 / 4.5 - 1);
      EXPECT_TRUE(isIn(frame * Vector3d(part.cwiseProduct(half)), box)) << part.transpose();
      const Vector3d round(half.x() * std::cos(i), half.x() * std::sin(i), half.y() * part.z());
      EXPECT_TRUE(isIn(frame * round, cylinder)) << round.transpose();
    }
  }
}

struct Humanoid : testing::Test {
  FakeSetup setup{robotNamed("humanoid"), "{}"};
  std::unique_ptr<ModelInterface> model = setup.createModel();
  std::vector<int> arm;
  void SetUp() override {
    model->syncFrom(setup.robot());
    for (const char* chain : {"left_arm", "right_arm"}) {
      for (int i = 0; i < 7; ++i) arm.push_back(model->findChain(chain)->joint(i).index());
    }
  }
};

TEST_F(Humanoid, PairsAreWhatCanTouch) {
  SelfDistance all(setup.robot().description(), *model, {});
  all.findPairs(*model, arm);
  EXPECT_GT(all.pairs(), 20U);
  config::RobotDescription described = setup.robot().description();
  described.srdf =
      R"(<robot name="humanoid"><disable_collisions link1="right_forearm" link2="left_forearm" reason="Never"/>
<disable_collisions link1="chest" link2="tail" reason="Never"/></robot>)";
  SelfDistance fewer(described, *model, {});
  fewer.findPairs(*model, arm);
  EXPECT_EQ(fewer.pairs() + 1, all.pairs());
  all.findPairs(*model, {});
  EXPECT_EQ(all.pairs(), 0U) << "nothing moves";
}

TEST_F(Humanoid, RowsAreTheDerivativeOfTheDistance) {
  SelfDistance distance(setup.robot().description(), *model, {0.02, 0.5});
  distance.findPairs(*model, arm);
  const auto joints = static_cast<Eigen::Index>(arm.size());
  VelocityBounds bounds(joints);
  bounds.upper.setConstant(1);
  bounds.lower = bounds.reach_lower = -bounds.upper;
  bounds.reach_upper = bounds.upper;
  TaskHierarchy hierarchy(joints, joints, SelfDistance::kMostNear);
  hierarchy.begin(bounds);
  distance.constrain(*model, hierarchy);
  ASSERT_GT(distance.rows(), 0);
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(joints, -0.2, 0.3);
  hierarchy.solve(Eigen::MatrixXd::Identity(joints, joints), wanted, false);
  const auto names = distance.names(0);
  const double before = distance.metres(0);
  Eigen::VectorXd at(model->getJointNum());
  model->getJointPosition(at);
  constexpr double kStep = 1e-5;
  for (Eigen::Index i = 0; i < joints; ++i) at[arm[static_cast<std::size_t>(i)]] += kStep * hierarchy.velocities()[i];
  model->setJointPosition(at);
  model->update();
  const double rate = -distance.row(0).dot(hierarchy.velocities());
  hierarchy.begin(bounds);
  distance.constrain(*model, hierarchy);
  Eigen::Index same = 0;  // symmetric pairs are as near as each other, and may change their places
  while (same + 1 < distance.rows() && distance.names(same) != names) ++same;
  EXPECT_EQ(distance.names(same), names);
  EXPECT_NEAR((distance.metres(same) - before) / kStep, rate, 1e-3);
}

}  // namespace
}  // namespace robotui::rt::plugins
