#include "sine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robotui/rt/testing/fake_setup.h"

namespace robotui::rt::plugins {
namespace {

using testing::FakeRobot;
using testing::FakeSetup;
using testing::PluginBench;

double greatestSwing(PluginBench& bench, FakeRobot& robot, double centre) {
  double greatest = 0;
  for (int i = 0; i < 10000; ++i) {
    bench.cycles(1);
    greatest = std::max(greatest, std::abs(robot.joint(0).getJointPosition() - centre));
  }
  return greatest;
}

TEST(Sine, SwingsAboutThePlaceWhereTheJointWas) {
  FakeRobot robot(2);
  robot.put("j1", 0.3);
  FakeSetup setup(robot, "{amplitude: 0.1, frequency: 0.5}");
  Sine sine;
  PluginBench bench(sine, setup);
  ASSERT_TRUE(bench.init()) << setup.failure();
  bench.start();
  EXPECT_NEAR(greatestSwing(bench, robot, 0.3), 0.1, 1e-4);
  EXPECT_EQ(bench.allocations(), 0u);
}

TEST(Sine, StaysWithinTheLimitsOfPosition) {
  FakeRobot robot(1);
  robot.put("j1", 1.9);
  FakeSetup setup(robot, "{amplitude: 1, frequency: 0.1}");
  Sine sine;
  PluginBench bench(sine, setup);
  ASSERT_TRUE(bench.init());
  bench.start();
  EXPECT_LE(greatestSwing(bench, robot, 1.9), 0.1);
}

TEST(Sine, StaysWithinTheLimitOfVelocity) {
  FakeRobot robot(1);
  FakeSetup setup(robot, "{amplitude: 1, frequency: 2}");
  Sine sine;
  PluginBench bench(sine, setup);
  ASSERT_TRUE(bench.init());
  bench.start();
  double fastest = 0;
  for (int i = 0; i < 5000; ++i) {
    bench.cycles(1);
    fastest = std::max(fastest, std::abs(robot.joint(0).getJointVelocity()));
  }
  EXPECT_LE(fastest, 1.0);
  EXPECT_GT(fastest, 0.7);
}

TEST(Sine, UnderstandsANewAmplitudeAndNothingElse) {
  FakeRobot robot(1);
  FakeSetup setup(robot, "");
  Sine sine;
  PluginBench bench(sine, setup);
  ASSERT_TRUE(bench.init());
  bench.start();
  EXPECT_TRUE(sine.on_command("amplitude 0.05"));
  EXPECT_FALSE(sine.on_command("amplitude nan"));
  EXPECT_FALSE(sine.on_command("frequency 1000"));
  EXPECT_FALSE(sine.on_command("dance"));
  EXPECT_NEAR(greatestSwing(bench, robot, 0), 0.05, 1e-4);
}

}  // namespace
}  // namespace robotui::rt::plugins
