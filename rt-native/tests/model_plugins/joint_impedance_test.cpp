#include "joint_impedance.h"

#include "fake_setup.h"

namespace robotui::rt::plugins {
namespace {

struct Impedance : testing::Test {
  FakeSetup setup{robotNamed("arm"), "{stiffness: 200, damping: 4, ramp: 0.1}"};
  JointImpedance plugin;
  void SetUp() override {
    ASSERT_TRUE(plugin.init_control_plugin(setup));
    EXPECT_TRUE(plugin.on_start(0).isOk());
  }
  const link::JointCommand& elbow() { return setup.robot().findJoint("elbow_pitch")->command(); }
};

TEST_F(Impedance, HoldsWhereItWasStarted) {
  run(plugin, setup, 1);
  EXPECT_NEAR(elbow().position, 1.35, 1e-12);
  EXPECT_EQ(elbow().mode, link::kPosition | link::kImpedance);
}

TEST_F(Impedance, ItsStiffnessGrowsSlowlyAndItsDampingIsThereAtOnce) {
  run(plugin, setup, 1);
  EXPECT_NEAR(elbow().stiffness, 2, 1e-9);
  EXPECT_EQ(elbow().damping, 4);
  EXPECT_EQ(plugin.status(), "changing its stiffness");
  run(plugin, setup, 100);
  EXPECT_EQ(elbow().stiffness, 200);
  EXPECT_EQ(plugin.status(), "holding");
}

TEST_F(Impedance, TakesWordsFromTheUser) {
  run(plugin, setup, 200);
  EXPECT_TRUE(plugin.on_command("stiffness 50"));
  EXPECT_TRUE(plugin.on_command("damping 2.5"));
  run(plugin, setup, 10);
  EXPECT_NEAR(elbow().stiffness, 180, 1);
  run(plugin, setup, 200);
  EXPECT_EQ(elbow().stiffness, 50);
  EXPECT_EQ(elbow().damping, 2.5);
}

TEST_F(Impedance, RefusesWordsThatAreNone) {
  for (const char* words :
       {"stiffness", "stiffness x", "stiffness -1", "stiffness nan", "stiffness 1 2", "stiffness 1e9", "fly", ""}) {
    EXPECT_FALSE(plugin.on_command(words)) << words;
  }
}

TEST(JointImpedance, TheModelCanCarryTheWeight) {
  FakeSetup setup(robotNamed("arm"), "{gravity: true, ramp: 0}");
  JointImpedance plugin;
  ASSERT_TRUE(plugin.init_control_plugin(setup));
  EXPECT_TRUE(plugin.on_start(0).isOk());
  run(plugin, setup, 5);
  EXPECT_EQ(setup.robot().joint(1).command().mode, link::kPosition | link::kEffort | link::kImpedance);
  const auto model = setup.createModel();
  model->syncFrom(setup.robot());
  Eigen::VectorXd weight(7);
  model->computeGravityCompensation(weight);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(setup.robot().joint(i).command().effort, weight[i], 1e-12);
  EXPECT_GT(weight.cwiseAbs().maxCoeff(), 5);
}

}  // namespace
}  // namespace robotui::rt::plugins
