#include "robotui/rt/robot/xbot_interface.h"

#include <gtest/gtest.h>

#include "robots.h"

namespace robotui::rt {
namespace {

struct Interface : testing::Test, XBotInterface {
  Interface() : XBotInterface(ownRobot("humanoid", true)) {}
};

TEST_F(Interface, FindsJointsByNameIdAndIndex) {
  EXPECT_EQ(getJointNum(), 31);
  const Joint* knee = findJoint("left_knee");
  ASSERT_NE(knee, nullptr);
  EXPECT_EQ(findJoint(knee->id()), knee);
  EXPECT_EQ(&joint(knee->index()), knee);
  EXPECT_EQ(findJoint("tail"), nullptr);
  EXPECT_EQ(findJoint(999), nullptr);
}

TEST_F(Interface, ChainsViewTheSameJoints) {
  KinematicChain* leg = findChain("right_leg");
  ASSERT_NE(leg, nullptr);
  EXPECT_EQ(leg->size(), 6);
  EXPECT_EQ(leg->baseLink(), "pelvis");
  EXPECT_EQ(leg->tipLink(), "right_sole");
  EXPECT_EQ(&leg->joint(3), findJoint("right_knee"));
  EXPECT_EQ(findChain("wing"), nullptr);
  EXPECT_EQ(chains().size(), 6U);
}

TEST_F(Interface, ReadsWhatTheStateSays) {
  const auto index = static_cast<std::size_t>(findJoint("left_knee")->index());
  states()[index].link_position = 0.5;
  states()[index].motor_position = 0.6;
  states()[index].fault = 4;
  EXPECT_EQ(findJoint("left_knee")->getJointPosition(), 0.5);
  EXPECT_EQ(findJoint("left_knee")->fault(), 4U);
  Eigen::VectorXd leg(6);
  findChain("left_leg")->getJointPosition(leg);
  EXPECT_EQ(leg[3], 0.5);
  Eigen::VectorXd all(getJointNum());
  getMotorPosition(all);
  EXPECT_EQ(all[static_cast<Eigen::Index>(index)], 0.6);
}

TEST_F(Interface, AReferenceSetsItsBitOfTheMode) {
  Joint& knee = *findJoint("left_knee");
  knee.setPositionReference(0.3);
  knee.setStiffness(200);
  knee.setDamping(5);
  EXPECT_EQ(knee.command().mode, link::kPosition | link::kStiffness | link::kDamping);
  EXPECT_EQ(knee.command().position, 0.3);
  knee.clear();
  EXPECT_EQ(knee.command().mode, 0);
  knee.setMode(link::kVelocity);
  EXPECT_EQ(commands()[static_cast<std::size_t>(knee.index())].mode, link::kVelocity);
}

TEST_F(Interface, WholeVectorsSetAllJoints) {
  setEffortReference(Eigen::VectorXd::Constant(getJointNum(), 2));
  for (int i = 0; i < getJointNum(); ++i) EXPECT_EQ(joint(i).command().mode, link::kEffort);
  findChain("head")->setVelocityReference(Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(findJoint("neck_pitch")->command().velocity, 0.2);
}

TEST_F(Interface, SensorsAreViewsWithTheirLinks) {
  ASSERT_EQ(imus().size(), 1U);
  EXPECT_EQ(imus()[0].link, "imu_link");
  EXPECT_TRUE(imus()[0].orientation().isApprox(Eigen::Quaterniond::Identity()));
  imuStates()[0].angular_velocity = {1, 2, 3};
  EXPECT_EQ(imus()[0].angularVelocity(), Eigen::Vector3d(1, 2, 3));
  ASSERT_EQ(forceTorques().size(), 4U);
  forceTorqueStates()[2].force = {0, 0, 9};
  EXPECT_EQ(forceTorques()[2].name, "left_ankle_ft");
  EXPECT_EQ(forceTorques()[2].force().z(), 9);
}

}  // namespace
}  // namespace robotui::rt
