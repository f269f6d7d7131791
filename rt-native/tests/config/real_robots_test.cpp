// The Panda and COMAN as they are published.
#include "workspace.h"

namespace robotui::rt::config {
namespace {

struct RealRobots : testing::Test {
  std::filesystem::path robots;
  Workspace at;
  void SetUp() override {
    const char* shared = std::getenv("ROBOTUI_SHARED");
    if (shared == nullptr) GTEST_SKIP() << "ROBOTUI_SHARED is not set";
    robots = std::filesystem::path(shared) / "data" / "robots";
  }
};

TEST_F(RealRobots, Coman) {
  const auto folder = robots / "coman_urdf";
  const auto robot =
      describe(folder / "urdf/coman.urdf", folder / "srdf/coman.srdf", folder / "config/coman_joint_map.yaml", true);
  EXPECT_EQ(robot.name, "coman");
  ASSERT_EQ(robot.joints.size(), 29U);
  EXPECT_EQ(robot.joints[0].name, "RShSag");
  EXPECT_EQ(robot.joints[28].id, 56);
  ASSERT_EQ(robot.chains.size(), 5U);
  EXPECT_EQ(robot.chains[0].name, "left_arm");
  EXPECT_EQ(robot.chains[0].joints.size(), 7U);
  EXPECT_EQ(robot.chains[2].joints.size(), 6U);
  EXPECT_EQ(robot.chains[4].joints, (std::vector<std::string>{"WaistLat", "WaistSag", "WaistYaw"}));
  EXPECT_EQ(robot.imus.at(0).link, "imu_link");
  ASSERT_EQ(robot.force_torques.size(), 4U);
  EXPECT_EQ(robot.force_torques[0].name, "l_leg_ft_joint");
  EXPECT_EQ(robot.postures.at(0).joints.size(), 29U);
}

TEST_F(RealRobots, Panda) {
  at.write("map.yaml",
           "joint_map: {1: panda_joint1, 2: panda_joint2, 3: panda_joint3, 4: panda_joint4, 5: panda_joint5, 6: "
           "panda_joint6, 7: panda_joint7}\n");
  const auto folder = robots / "panda_description";
  const auto robot = describe(folder / "urdf/panda.urdf", folder / "srdf/panda.srdf", at.file("map.yaml"), false);
  EXPECT_EQ(robot.joints.size(), 7U);
  ASSERT_EQ(robot.chains.size(), 1U);
  EXPECT_EQ(robot.chains[0].name, "arm");
  EXPECT_EQ(robot.chains[0].tip_link, "panda_link7");
  EXPECT_EQ(robot.postures.at(0).name, "default");
  EXPECT_EQ(robot.postures[0].joints.size(), 7U);
}

TEST_F(RealRobots, AFingerThatFollowsAnotherIsNotCommanded) {
  at.write("map.yaml", "joint_map: {1: panda_finger_joint2}\n");
  const auto folder = robots / "panda_description";
  EXPECT_THROW(describe(folder / "urdf/panda.urdf", {}, at.file("map.yaml"), false), ConfigError);
}

}  // namespace
}  // namespace robotui::rt::config
