#include "gravity_compensation.h"

#include "fake_setup.h"

namespace robotui::rt::plugins {
namespace {

TEST(GravityCompensation, SendsTheWeightOfTheModelAndNothingElse) {
  FakeSetup setup(robotNamed("arm"), "{damping: 0}");
  GravityCompensation plugin;
  ASSERT_TRUE(plugin.init_control_plugin(setup));
  EXPECT_EQ(setup.claimed.size(), 7U);
  EXPECT_TRUE(plugin.on_start(0).isOk());
  run(plugin, setup, 50);
  const auto model = setup.createModel();
  model->syncFrom(setup.robot());
  Eigen::VectorXd weight(7);
  model->computeGravityCompensation(weight);
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(setup.robot().joint(i).command().effort, weight[i], 1e-12);
    EXPECT_EQ(setup.robot().joint(i).command().mode, link::kEffort);
  }
  EXPECT_GT(weight.cwiseAbs().maxCoeff(), 10);
}

TEST(GravityCompensation, DampsMotion) {
  FakeSetup setup(robotNamed("arm"), "{damping: 3, joints: [shoulder_yaw]}");
  GravityCompensation plugin;
  ASSERT_TRUE(plugin.init_control_plugin(setup));
  setup.robot().state("shoulder_yaw").link_velocity = 0.5;
  run(plugin, setup, 1);
  EXPECT_NEAR(setup.robot().findJoint("shoulder_yaw")->command().effort, -1.5, 1e-9);
  EXPECT_EQ(setup.robot().findJoint("elbow_pitch")->command().mode, 0);
}

TEST(GravityCompensation, AFloatingBaseIsTurnedByItsImu) {
  FakeSetup setup(robotNamed("humanoid"), "{chains: [left_arm], damping: 0}");
  GravityCompensation plugin;
  ASSERT_TRUE(plugin.init_control_plugin(setup));
  run(plugin, setup, 2);
  const double upright = setup.robot().findJoint("left_elbow")->command().effort;
  setup.robot().imu().orientation = {1, 0, 0, 0};  // on its head
  run(plugin, setup, 2);
  EXPECT_NEAR(setup.robot().findJoint("left_elbow")->command().effort, -upright, 1e-9);
  EXPECT_GT(std::abs(upright), 0.5);
}

TEST(GravityCompensation, WrongParametersAreNamed) {
  FakeSetup setup(robotNamed("arm"), "{dampign: 1}");
  GravityCompensation plugin;
  EXPECT_THROW(plugin.init_control_plugin(setup), config::ConfigError);
  FakeSetup other(robotNamed("arm"), "{joints: [tail]}");
  GravityCompensation second;
  EXPECT_THROW(second.init_control_plugin(other), config::ConfigError);
}

}  // namespace
}  // namespace robotui::rt::plugins
