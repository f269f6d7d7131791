#include "mujoco_hal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robotui/rt/link/allocations.h"
#include "robotui/rt/robot/model_interface.h"
#include "simulated.h"

namespace robotui::rt::hal {
namespace {

struct Arm : testing::Test {
  Simulated arm{robotNamed("arm")};
};

TEST_F(Arm, StartsInItsPostureAndHoldsIt) {
  EXPECT_NEAR(arm.joint("elbow_pitch").link_position, 1.35, 1e-9);
  ASSERT_EQ(arm.run(1000), Status::kOk);
  EXPECT_NEAR(arm.joint("elbow_pitch").link_position, 1.35, 1e-3);
  EXPECT_NEAR(arm.joint("elbow_pitch").link_velocity, 0, 1e-3);
}

TEST_F(Arm, FollowsAPosition) {
  arm.reference("shoulder_yaw").position = 0.8;
  ASSERT_EQ(arm.run(2000), Status::kOk);
  EXPECT_NEAR(arm.joint("shoulder_yaw").link_position, 0.8, 2e-3);
}

TEST_F(Arm, FollowsAVelocity) {
  arm.reference("shoulder_yaw") = {0, 0.5, 0, 0, 0, link::kVelocity};
  ASSERT_EQ(arm.run(1000), Status::kOk);
  EXPECT_NEAR(arm.joint("shoulder_yaw").link_velocity, 0.5, 0.01);
}

TEST_F(Arm, FallsWithoutEffortAndFloatsWithTheEffortsOfTheModel) {
  const auto model = ModelInterface::create("KDL", arm.robot);
  Eigen::VectorXd q(7);
  Eigen::VectorXd tau(7);
  for (int cycle = 0; cycle < 1000; ++cycle) {
    for (std::size_t i = 0; i < 7; ++i) q[static_cast<Eigen::Index>(i)] = arm.joints[i].link_position;
    model->setJointPosition(q);
    model->update();
    model->computeGravityCompensation(tau);
    for (std::size_t i = 0; i < 7; ++i)
      arm.references[i] = {0, 0, tau[static_cast<Eigen::Index>(i)], 0, 0, link::kEffort};
    ASSERT_EQ(arm.run(1), Status::kOk);
  }
  EXPECT_NEAR(arm.joint("elbow_pitch").link_position, 1.35, 0.02);
  for (auto& reference : arm.references) reference.effort = 0;
  ASSERT_EQ(arm.run(500), Status::kOk);
  EXPECT_GT(std::abs(arm.joint("shoulder_pitch").link_position - 0.45), 0.1);
}

TEST_F(Arm, ImpedanceGivesWayAsASpringDoes) {
  auto& roll = arm.reference("shoulder_yaw");
  roll = {0, 0, 5, 100, 30, static_cast<std::uint8_t>(link::kPosition | link::kEffort | link::kImpedance)};
  ASSERT_EQ(arm.run(4000), Status::kOk);
  EXPECT_NEAR(arm.joint("shoulder_yaw").link_position, 5.0 / 100, 2e-3);
}

TEST_F(Arm, EffortsStayWithinTheLimitsOfTheJoint) {
  arm.reference("wrist_roll") = {0, 0, 1e6, 0, 0, link::kEffort};
  ASSERT_EQ(arm.run(5), Status::kOk);
  EXPECT_NEAR(arm.joint("wrist_roll").effort, 15, 1e-9);
}

// At the tip as at a joint: what gives way says how strong it is.
TEST_F(Arm, IsPushedAtAJointAndAtALinkForAsLongAsIsSaid) {
  const auto push = [&](const std::string& link, std::array<double, 3> force) {
    link::Push wish{0, 3, {}, link, force};
    if (link.empty()) wish.joint = static_cast<std::uint32_t>(arm.index("shoulder_yaw"));
    return arm.hal.push(wish);
  };
  arm.reference("shoulder_yaw") = {0, 0, 0, 100, 30, static_cast<std::uint8_t>(link::kPosition | link::kImpedance)};
  EXPECT_EQ(push("", {5, 0, 0}), "");
  ASSERT_EQ(arm.run(2900), Status::kOk);
  EXPECT_NEAR(arm.joint("shoulder_yaw").link_position, 5.0 / 100, 2e-3);
  ASSERT_EQ(arm.run(3000), Status::kOk);
  EXPECT_NEAR(arm.joint("shoulder_yaw").link_position, 0, 1e-3);
  const auto model = ModelInterface::create("KDL", arm.robot);
  Eigen::VectorXd q(7);
  for (std::size_t i = 0; i < 7; ++i) q[static_cast<Eigen::Index>(i)] = arm.joints[i].link_position;
  model->setJointPosition(q);
  model->update();
  Eigen::Isometry3d tip;
  model->getPose(model->findLink("tip"), tip);
  EXPECT_EQ(push("tip", {0, 10, 0}), "");
  ASSERT_EQ(arm.run(2900), Status::kOk);
  EXPECT_NEAR(arm.joint("shoulder_yaw").link_position, 10 * tip.translation().x() / 100, 2e-3);
  EXPECT_NE(push("nose", {}), "");
}

TEST_F(Arm, TheWristFeelsTheWeightOfTheTool) {
  ASSERT_EQ(arm.run(1000), Status::kOk);
  const auto& force = arm.force_torques.at(0).force;
  EXPECT_NEAR(std::hypot(force[0], force[1], force[2]), 0.5 * 9.81, 0.05);
}

TEST_F(Arm, NoCycleAllocates) {
  arm.run(10);
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    arm.run(200);
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

TEST_F(Arm, OpensAgainAfterClose) {
  arm.hal.close();
  config::HalConfig config;
  config.params = YAML::Load("{steps: 4}");
  arm.hal.open(*arm.robot, config, 1'000'000);
  EXPECT_EQ(arm.sense(), Status::kOk);
}

TEST(MujocoSettings, WrongOnesAreNamed) {
  const RobotPtr robot = robotNamed("arm");
  config::HalConfig config;
  const auto expect = [&](const std::string& params, const std::string& said) {
    config.params = YAML::Load(params);
    try {
      readMujocoSettings(config, *robot, 1'000'000);
      ADD_FAILURE() << "no mistake in " << params;
    } catch (const config::ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  };
  expect("{stepz: 2}", "did you mean 'steps'?");
  expect("{steps: 0}", "expected a whole number from 1 to 100");
  expect("{posture: hom}", "did you mean 'home'?");
}

TEST(MujocoSettings, StepsAreShortEnoughForThePeriod) {
  config::HalConfig config;
  config.params = YAML::Load("{}");
  EXPECT_EQ(readMujocoSettings(config, *robotNamed("arm"), 1'000'000).steps, 2);
  EXPECT_EQ(readMujocoSettings(config, *robotNamed("arm"), 250'000).steps, 1);
  EXPECT_EQ(readMujocoSettings(config, *robotNamed("arm"), 4'000'000).steps, 8);
}

}  // namespace
}  // namespace robotui::rt::hal
