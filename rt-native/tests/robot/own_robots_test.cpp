// The robots of our own could be built: masses, inertias, postures, limits.
#include <gtest/gtest.h>

#include "robotui/rt/robot/rigid_tree.h"
#include "robots.h"

namespace robotui::rt {
namespace {

struct OwnRobots : testing::TestWithParam<std::string> {
  RobotPtr robot = robotNamed(GetParam());
  RigidTree tree = buildRigidTree(*robot);
};

TEST_P(OwnRobots, EveryMovingBodyHasAMassAndAPossibleInertia) {
  for (const auto& body : tree.bodies) {
    EXPECT_GT(body.mass, 0.1) << body.name;
    const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
    EXPECT_GT(moments[0], 0) << body.name;
    EXPECT_GE(moments[0] + moments[1], moments[2] * (1 - 1e-9)) << body.name;
  }
}

TEST_P(OwnRobots, EveryJointIsInTheMapAndInOneChain) {
  std::map<std::string, int> chains;
  for (const auto& chain : robot->chains) {
    for (const auto& joint : chain.joints) ++chains[joint];
  }
  EXPECT_EQ(tree.bodies.size(), robot->joints.size() + 1);
  for (const auto& joint : robot->joints) EXPECT_EQ(chains[joint.name], 1) << joint.name;
}

TEST_P(OwnRobots, PosturesNameAllJointsAndLieWithinTheLimits) {
  ASSERT_FALSE(robot->postures.empty());
  EXPECT_EQ(robot->postures[0].name, "home");
  for (const auto& posture : robot->postures) {
    EXPECT_EQ(posture.joints.size(), robot->joints.size()) << posture.name;
  }
}

TEST_P(OwnRobots, EveryBodyCanBeSeenAndTouched) {
  std::map<int, int> shapes;
  for (const auto& shape : tree.shapes) ++shapes[shape.body];
  EXPECT_GE(shapes.size(), tree.bodies.size() / 2);
  EXPECT_EQ(robot->urdf.find("<mesh"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Both, OwnRobots, testing::Values("arm", "humanoid"), [](const auto& at) { return at.param; });

TEST(OwnRobots, WeighWhatSuchRobotsWeigh) {
  EXPECT_NEAR(buildRigidTree(*robotNamed("arm")).mass(), 20.7, 0.1);
  EXPECT_NEAR(buildRigidTree(*robotNamed("humanoid")).mass(), 68, 8);
}

TEST(RigidTree, LinksApartBeginBodiesOfTheirOwn) {
  const RobotPtr robot = robotNamed("arm");
  const RigidTree whole = buildRigidTree(*robot);
  const RigidTree parted = buildRigidTree(*robot, {"tool"});
  EXPECT_EQ(parted.bodies.size(), whole.bodies.size() + 1);
  EXPECT_NEAR(parted.mass(), whole.mass(), 1e-12);
  EXPECT_EQ(parted.links.at("tip").body, parted.links.at("tool").body);
  EXPECT_NE(parted.links.at("tip").body, parted.links.at("flange").body);
}

}  // namespace
}  // namespace robotui::rt
