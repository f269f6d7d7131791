#include "homing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robotui/rt/testing/fake_setup.h"

namespace robotui::rt::plugins {
namespace {

using testing::FakeRobot;
using testing::FakeSetup;
using testing::PluginBench;

TEST(Homing, MovesEachJointToThePostureAndStaysThere) {
  FakeRobot robot(3);
  FakeSetup setup(robot, "");
  Homing homing;
  PluginBench bench(homing, setup);
  ASSERT_TRUE(bench.init()) << setup.failure();
  EXPECT_EQ(setup.claims(), (std::vector<std::string>{"j1", "j2", "j3"}));
  bench.start();
  bench.run(10);
  EXPECT_DOUBLE_EQ(robot.joint(0).getJointPosition(), 0.5);
  EXPECT_DOUBLE_EQ(robot.joint(2).getJointPosition(), 0.5);
  EXPECT_EQ(homing.status(), "at home");
  EXPECT_EQ(bench.allocations(), 0u);
}

TEST(Homing, KeepsToTheFractionOfTheVelocityLimit) {
  FakeRobot robot(1);
  robot.put("j1", -1.5);
  FakeSetup setup(robot, "{speed: 0.5}");
  Homing homing;
  PluginBench bench(homing, setup);
  ASSERT_TRUE(bench.init());
  bench.start();
  double fastest = 0;
  for (int i = 0; i < 9000; ++i) {
    bench.cycles(1);
    fastest = std::max(fastest, std::abs(robot.joint(0).getJointVelocity()));
  }
  EXPECT_LE(fastest, 0.5 + 1e-6);
  EXPECT_GT(fastest, 0.49);
  EXPECT_DOUBLE_EQ(robot.joint(0).getJointPosition(), 0.5);
}

TEST(Homing, BeginsWhereTheReferencesAre) {
  FakeRobot robot(1);
  robot.put("j1", 1.0);
  FakeSetup setup(robot, "{time: 2}");
  Homing homing;
  PluginBench bench(homing, setup);
  ASSERT_TRUE(bench.init());
  bench.start();
  bench.cycles(1);
  EXPECT_NEAR(robot.joint(0).getJointPosition(), 1.0, 1e-6);
}

TEST(Homing, TakesOnlyTheJointsItIsGiven) {
  FakeRobot robot(3);
  FakeSetup setup(robot, "{posture: zero, joints: [j2]}");
  Homing homing;
  PluginBench bench(homing, setup);
  ASSERT_TRUE(bench.init());
  EXPECT_EQ(setup.claims(), std::vector<std::string>{"j2"});
  bench.start();
  bench.cycles(1);
  EXPECT_EQ(robot.commanded(), 1);
}

// A robot that fell, or whose joint is blocked, was told all the same.
TEST(Homing, IsAtHomeOnlyWhereTheJointsAre) {
  FakeRobot robot(3);
  FakeSetup setup(robot, "{tolerance: 0.1}");
  Homing homing;
  PluginBench bench(homing, setup);
  ASSERT_TRUE(bench.init());
  bench.start();
  bench.run(10);
  robot.put("j2", 0.59);
  bench.cycles(1);
  EXPECT_EQ(homing.status(), "at home");
  robot.put("j2", -1.35);
  bench.cycles(1);
  EXPECT_EQ(homing.status(), "j2 is 1.85 away from home");
  EXPECT_EQ(bench.allocations(), 0u);
  bench.cycles(1);
  EXPECT_EQ(homing.status(), "at home");
}

TEST(Homing, NamesAPostureThatIsNotThere) {
  FakeRobot robot(1);
  FakeSetup setup(robot, "{posture: nowhere}");
  Homing homing;
  EXPECT_FALSE(PluginBench(homing, setup).init());
  EXPECT_NE(setup.failure().find("'nowhere'"), std::string::npos);
}

}  // namespace
}  // namespace robotui::rt::plugins
