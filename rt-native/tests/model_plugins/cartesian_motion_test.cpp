#include "cartesian_motion.h"

#include "fake_setup.h"

namespace robotui::rt::plugins {
namespace {

struct Cartesian : testing::Test {
  FakeSetup setup{robotNamed("arm"), "{linear_speed: 0.2, angular_speed: 1}"};
  CartesianMotion plugin;
  std::unique_ptr<ModelInterface> model = setup.createModel();
  void SetUp() override {
    ASSERT_TRUE(plugin.init_control_plugin(setup));
    EXPECT_TRUE(plugin.on_start(0).isOk());
  }
  Eigen::Isometry3d tip() {
    Eigen::Isometry3d pose;
    model->syncFrom(setup.robot());
    model->getPose(model->findLink("tip"), pose);
    return pose;
  }
};

TEST_F(Cartesian, HoldsUntilItIsTold) {
  const Eigen::Isometry3d before = tip();
  run(plugin, setup, 200);
  EXPECT_LT((tip().matrix() - before.matrix()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(plugin.status(), "at the target");
  EXPECT_EQ(setup.claimed.size(), 7U);
}

TEST_F(Cartesian, MovesInAStraightLineWithLimitedSpeed) {
  const Eigen::Isometry3d before = tip();
  ASSERT_TRUE(plugin.on_command("move 0.1 0.05 -0.1"));
  const Eigen::Vector3d way(0.1, 0.05, -0.1);
  Eigen::Vector3d last = before.translation();
  for (int i = 0; i < 20; ++i) {
    run(plugin, setup, 25);
    const Eigen::Vector3d now = tip().translation();
    EXPECT_LT((now - last).norm(), 0.2 * 0.025 * 1.01);
    EXPECT_LT((now - before.translation()).cross(way.normalized()).norm(), 1e-3);
    last = now;
  }
  run(plugin, setup, 2000);
  EXPECT_LT((tip().translation() - before.translation() - way).norm(), 1e-3);
  EXPECT_LT((tip().linear() - before.linear()).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_EQ(plugin.status(), "at the target");
}

TEST_F(Cartesian, TurnsToAPose) {
  const Eigen::Vector3d at = tip().translation();
  ASSERT_TRUE(plugin.on_command("move 0 0 0 0 0.4 0.3"));
  run(plugin, setup, 3000);
  EXPECT_EQ(plugin.status(), "at the target");
  EXPECT_LT((tip().translation() - at).norm(), 2e-3);
}

TEST_F(Cartesian, StaysWithinPositionsAndVelocitiesWhereTheTargetIsOutOfReach) {
  ASSERT_TRUE(plugin.on_command("pose 3 0 -2"));
  std::vector<double> last(7);
  for (int i = 0; i < 7; ++i) last[static_cast<std::size_t>(i)] = setup.robot().joint(i).getJointPosition();
  for (int cycle = 0; cycle < 8000; ++cycle) {
    EXPECT_TRUE(plugin.control_loop(0, 0.001).isOk());
    setup.robot().follow();
    for (int i = 0; i < 7; ++i) {
      const auto& joint = setup.robot().joint(i);
      const double now = joint.getJointPosition();
      ASSERT_TRUE(std::isfinite(now));
      ASSERT_LE(now, joint.description().upper);
      ASSERT_GE(now, joint.description().lower);
      ASSERT_LE(std::abs(now - last[static_cast<std::size_t>(i)]), joint.description().velocity * 0.001 * 1.001);
      last[static_cast<std::size_t>(i)] = now;
    }
  }
  EXPECT_TRUE(plugin.status().starts_with("it cannot go on: ")) << plugin.status();
  ASSERT_TRUE(plugin.on_command("stop"));
  run(plugin, setup, 500);
  EXPECT_EQ(plugin.status(), "at the target");
}

TEST_F(Cartesian, RefusesWordsThatAreNone) {
  for (const char* words :
       {"move", "move 1", "move a b c", "pose 1 2 3 4", "pose 1 2 1e9", "pose nan 0 0", "jump 1 2 3", ""}) {
    EXPECT_FALSE(plugin.on_command(words)) << words;
  }
}

TEST(CartesianMotion, TheChainMustBeSaidWhereThereAreSeveral) {
  FakeSetup setup(robotNamed("humanoid"), "{}");
  CartesianMotion plugin;
  EXPECT_FALSE(plugin.init_control_plugin(setup));
  EXPECT_NE(setup.failure.find("6 chains"), std::string::npos);
}

TEST(CartesianMotion, TheFrameIsThatOfTheChainsBase) {
  FakeSetup setup(robotNamed("humanoid"), "{chain: left_arm}");
  setup.robot().state("torso_yaw").link_position = 1;  // what turns the base of the chain does not matter
  CartesianMotion plugin;
  ASSERT_TRUE(plugin.init_control_plugin(setup));
  EXPECT_TRUE(plugin.on_start(0).isOk());
  const auto model = setup.createModel();
  const auto in_chest = [&] {
    Eigen::Isometry3d chest;
    Eigen::Isometry3d hand;
    model->syncFrom(setup.robot());
    model->getPose(model->findLink("chest"), chest);
    model->getPose(model->findLink("left_hand"), hand);
    return Eigen::Vector3d((chest.inverse() * hand).translation());
  };
  const Eigen::Vector3d before = in_chest();
  ASSERT_TRUE(plugin.on_command("move 0.05 0 0.05"));
  run(plugin, setup, 3000);
  EXPECT_LT((in_chest() - before - Eigen::Vector3d(0.05, 0, 0.05)).norm(), 2e-3);
}

TEST(CartesianMotion, WrongParametersAreNamed) {
  for (const char* params : {"{chain: tail}", "{linear_speed: 0}", "{pose: [1, 2]}", "{sped: 1}"}) {
    FakeSetup setup(robotNamed("arm"), params);
    CartesianMotion plugin;
    EXPECT_THROW(plugin.init_control_plugin(setup), config::ConfigError) << params;
  }
}

}  // namespace
}  // namespace robotui::rt::plugins
