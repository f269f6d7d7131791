#include "communication.h"

#include <gtest/gtest.h>

#include <limits>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/testing/fake_setup.h"

namespace robotui::rt::plugins {
namespace {

using testing::FakeRobot;
using testing::FakeSetup;
using testing::PluginBench;

class CommunicationTest : public ::testing::Test {
 protected:
  CommunicationTest() : setup_(robot_, ""), bench_(plugin_, setup_), master_(setup_.masterSegment(), 2) {
    robot_.put("j1", 0.1);
    robot_.put("j2", 0.2);
    EXPECT_TRUE(bench_.init());
  }

  void refer(double position, std::int64_t valid_ns) {
    link::MasterData data{};
    data.valid_until_ns = link::now() + valid_ns;
    data.joints[0].position = position;
    data.joints[0].mode = link::kPosition;
    master_.write(data);
  }

  FakeRobot robot_{2};
  FakeSetup setup_;
  XBotCommunicationPlugin plugin_;
  PluginBench bench_;
  link::MasterWriter master_;
};

TEST_F(CommunicationTest, HoldsAllJointsUntilAReferenceComes) {
  bench_.start();
  bench_.cycles(5);
  EXPECT_DOUBLE_EQ(robot_.joint(0).getJointPosition(), 0.1);
  EXPECT_EQ(robot_.commanded(), 2);
  EXPECT_EQ(plugin_.status(), "waiting for references");
}

TEST_F(CommunicationTest, FollowsTheMasterAndHoldsTheOtherJoints) {
  bench_.start();
  refer(0.7, 60 * link::kSecond);
  bench_.run(0.7);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 0.7, 1e-9);
  EXPECT_DOUBLE_EQ(robot_.joint(1).getJointPosition(), 0.2);
  EXPECT_EQ(plugin_.status(), "following the master");
  EXPECT_EQ(bench_.allocations(), 0u);
}

TEST_F(CommunicationTest, HoldsTheLastPlaceWhenTheReferenceIsOld) {
  bench_.start();
  refer(0.7, 60 * link::kSecond);
  bench_.run(0.7);
  refer(0.9, -1);
  bench_.cycles(3);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 0.7, 1e-9);
}

TEST_F(CommunicationTest, GoesFromOneReferenceOfASlowMasterToTheNextInEvenSteps) {
  bench_.start();
  refer(0.1, 60 * link::kSecond);
  bench_.run(0.05);
  refer(0.11, 60 * link::kSecond);
  bench_.run(0.025);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 0.105, 3e-4);
  bench_.run(0.03);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 0.11, 1e-9);
}

TEST_F(CommunicationTest, ReachesAReferenceThatWasSaidOnce) {
  bench_.start();
  refer(0.7, 60 * link::kSecond);
  bench_.run(0.05);
  refer(0.7, -1);
  bench_.run(1);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 0.7, 1e-9);
}

TEST_F(CommunicationTest, MovesNoFasterThanTheJointMay) {
  bench_.start();
  refer(1.9, 60 * link::kSecond);
  bench_.run(0.5);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 0.1 + 0.5, 2e-3);
}

TEST_F(CommunicationTest, ComesBackAtOnceFromAReferenceBeyondTheLimits) {
  bench_.start();
  refer(9, 60 * link::kSecond);
  bench_.run(4);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 2, 2e-3);
  refer(1.5, 60 * link::kSecond);
  bench_.run(0.6);
  EXPECT_NEAR(robot_.joint(0).getJointPosition(), 1.5, 1e-9);
}

TEST_F(CommunicationTest, IgnoresWhatIsNoNumberAndWhatWasSaidBeforeTheStart) {
  refer(1.5, link::kSecond);
  bench_.start();
  bench_.cycles(1);
  EXPECT_DOUBLE_EQ(robot_.joint(0).getJointPosition(), 0.1);
  refer(std::numeric_limits<double>::quiet_NaN(), link::kSecond);
  bench_.cycles(1);
  EXPECT_DOUBLE_EQ(robot_.joint(0).getJointPosition(), 0.1);
}

}  // namespace
}  // namespace robotui::rt::plugins
