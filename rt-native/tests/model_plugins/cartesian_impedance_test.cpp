#include "cartesian_impedance.h"

#ifdef RT_WITH_MUJOCO
#include "simulated_setup.h"
#else
#include "fake_setup.h"
#endif

namespace robotui::rt::plugins {
namespace {

constexpr const char* kSprings = "{stiffness: [400, 800, 600, 40, 40, 40], damping: [60, 80, 70, 6, 6, 6], ramp: 0.2}";

struct CartesianImpedanceTest : testing::Test {
  FakeSetup setup{robotNamed("arm"), kSprings};
  CartesianImpedance plugin;
  std::unique_ptr<ModelInterface> model = setup.createModel();
  Eigen::Isometry3d tip() {
    Eigen::Isometry3d pose;
    model->syncFrom(setup.robot());
    model->getPose(model->findLink("tip"), pose);
    return pose;
  }
  void start() {
    ASSERT_TRUE(plugin.init_control_plugin(setup)) << setup.failure;
    EXPECT_TRUE(plugin.on_start(0).isOk());
  }
};

TEST_F(CartesianImpedanceTest, CarriesTheWeightWhereItWasStartedAndAllocatesNothing) {
  start();
  run(plugin, setup, 50);
  EXPECT_EQ(setup.claimed.size(), 7U);
  EXPECT_EQ(plugin.status(), "at the target");
  model->syncFrom(setup.robot());
  Eigen::VectorXd weight(7);
  model->computeGravityCompensation(weight);
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(setup.robot().joint(i).command().mode, link::kEffort);
    EXPECT_NEAR(setup.robot().joint(i).command().effort, weight[i], 1e-9);
  }
}

TEST_F(CartesianImpedanceTest, UsesNoMoreEffortThanItMay) {
  start();
  ASSERT_TRUE(plugin.on_command("stiffness 100000 100000 100000 1000 1000 1000"));
  run(plugin, setup, 300);
  setup.robot().state("shoulder_yaw").link_position += 0.5;
  run(plugin, setup, 5);
  for (int i = 0; i < 7; ++i) {
    const Joint& joint = setup.robot().joint(i);
    EXPECT_LE(std::abs(joint.command().effort), 0.8 * joint.description().effort + 1e-9) << joint.name();
  }
  EXPECT_NE(plugin.status().find("gives way by "), std::string_view::npos) << plugin.status();
  EXPECT_NE(plugin.status().find("with the most effort that it may use"), std::string_view::npos) << plugin.status();
}

TEST_F(CartesianImpedanceTest, RefusesWordsThatAreNone) {
  start();
  for (const char* words : {"", "fly", "pose", "pose 1", "pose 1 2 x", "stiffness 1 2 3", "stiffness 1 2 3 4 5 -6",
                            "damping 1 2 3 4 5 nan", "damping 1 2 3 4 5 1e9", "stop 1"})
    EXPECT_FALSE(plugin.on_command(words)) << words;
  EXPECT_TRUE(plugin.on_command("damping 1 2 3 4 5 6"));
  EXPECT_TRUE(plugin.on_command("stop"));
}

TEST(CartesianImpedanceParameters, WrongOnesAreNamed) {
  const auto expect = [](const std::string& params, const std::string& said) {
    FakeSetup setup(robotNamed("arm"), params);
    try {
      CartesianImpedance().init_control_plugin(setup);
      ADD_FAILURE() << "no mistake in " << params;
    } catch (const config::ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  };
  expect("{stiffness: [1, 2, 3]}", "has 3 numbers; expected 6");
  expect("{stifness: [1, 2, 3, 4, 5, 6]}", "did you mean 'stiffness'?");
  expect("{axes: world}", "base");
  expect("{tolerance: [0.1]}", "needs two numbers");
}

#ifdef RT_WITH_MUJOCO
struct PushedTip : CartesianImpedanceTest {
  void push(std::array<double, 3> force, double seconds) {
    link::Push push;
    push.seconds = seconds;
    push.link = "tip";
    push.force = force;
    EXPECT_EQ(robot.hal.push(push), "");
  }
  SimulatedRobot robot{setup};
};

// Each axis gives way by force over stiffness, alone, and returns.
TEST_F(PushedTip, GivesWayByForceOverStiffnessAndReturns) {
  start();
  robot.run(plugin, 500);
  const Eigen::Vector3d before = tip().translation();
  const std::array<double, 3> stiffness{400, 800, 600};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<double, 3> force{};
    force[axis] = 20;
    push(force, 3);
    robot.run(plugin, 2900);
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    expected[static_cast<Eigen::Index>(axis)] = 20 / stiffness[axis];
    const Eigen::Vector3d moved = tip().translation() - before;
    EXPECT_LT((moved - expected).norm(), 0.03 * expected.norm()) << moved.transpose();
    EXPECT_NE(plugin.status().find("gives way by "), std::string_view::npos) << plugin.status();
    robot.run(plugin, 3000);
    EXPECT_LT((tip().translation() - before).norm(), 1e-3);
    EXPECT_EQ(plugin.status(), "at the target");
  }
}

TEST_F(PushedTip, GoesToAPoseAndHoldsItAsSoftly) {
  start();
  const Eigen::Vector3d before = tip().translation();
  ASSERT_TRUE(plugin.on_command("move 0.05 0.1 -0.05"));
  robot.run(plugin, 4000);
  EXPECT_EQ(plugin.status(), "at the target");
  EXPECT_LT((tip().translation() - before - Eigen::Vector3d(0.05, 0.1, -0.05)).norm(), 3e-3);
}
#endif

}  // namespace
}  // namespace robotui::rt::plugins
