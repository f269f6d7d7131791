#include <cmath>

#include "workspace.h"

namespace robotui::rt::config {
namespace {

RobotDescription described(const Workspace& at) {
  return describe(at.file("robot.urdf"), at.file("robot.srdf"), at.file("map.yaml"), false);
}

TEST(Describe, JointsComeInTheOrderOfTheirIdsWithTheLimitsOfTheUrdf) {
  const auto robot = described(Workspace{});
  ASSERT_EQ(robot.joints.size(), 2U);
  EXPECT_EQ(robot.joints[0].name, "shoulder");
  EXPECT_EQ(robot.joints[0].id, 3);
  EXPECT_EQ(robot.joints[0].lower, -1);
  EXPECT_EQ(robot.joints[0].upper, 2);
  EXPECT_EQ(robot.joints[0].velocity, 3);
  EXPECT_EQ(robot.joints[0].effort, 40);
}

TEST(Describe, AContinuousJointHasNoEnd) {
  const auto elbow = described(Workspace{}).joints[1];
  EXPECT_EQ(elbow.type, JointType::kRevolute);
  EXPECT_TRUE(std::isinf(elbow.lower) && elbow.lower < 0);
  EXPECT_TRUE(std::isinf(elbow.upper) && elbow.upper > 0);
}

TEST(Describe, AChainGoesFromBaseToTipWithoutFixedJoints) {
  const auto robot = described(Workspace{});
  ASSERT_EQ(robot.chains.size(), 1U);
  EXPECT_EQ(robot.chains[0].name, "arm");
  EXPECT_EQ(robot.chains[0].base_link, "base");
  EXPECT_EQ(robot.chains[0].tip_link, "hand");
  EXPECT_EQ(robot.chains[0].joints, (std::vector<std::string>{"shoulder", "elbow"}));
}

TEST(Describe, WithoutAGroupChainsEveryGroupThatIsAChainIsOne) {
  Workspace at;
  at.write("robot.srdf", R"(<robot name="two"><group name="a"><joint name="elbow"/><joint name="shoulder"/></group>
    <group name="just_a_link"><link name="base"/></group><group name="both"><group name="a"/></group></robot>)");
  const auto robot = described(at);
  ASSERT_EQ(robot.chains.size(), 1U);
  EXPECT_EQ(robot.chains[0].joints, (std::vector<std::string>{"shoulder", "elbow"}));
  EXPECT_EQ(robot.chains[0].tip_link, "lower");
}

TEST(Describe, SensorsAndPosturesComeFromTheSrdf) {
  const auto robot = described(Workspace{});
  ASSERT_EQ(robot.imus.size(), 1U);
  EXPECT_EQ(robot.imus[0].link, "base");
  ASSERT_EQ(robot.force_torques.size(), 1U);
  EXPECT_EQ(robot.force_torques[0].name, "wrist_mount");
  EXPECT_EQ(robot.force_torques[0].link, "hand");
  ASSERT_EQ(robot.postures.size(), 1U);
  EXPECT_EQ(robot.postures[0].joints[1], (std::pair<std::string, double>{"elbow", -1}));
}

TEST(Describe, WorksWithoutAnSrdf) {
  const Workspace at;
  EXPECT_TRUE(describe(at.file("robot.urdf"), {}, at.file("map.yaml"), true).chains.empty());
}

}  // namespace
}  // namespace robotui::rt::config
