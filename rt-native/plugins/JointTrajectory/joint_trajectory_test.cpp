#include "joint_trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>

#include "robotui/rt/testing/fake_setup.h"

namespace robotui::rt::plugins {
namespace {

using testing::FakeRobot;
using testing::FakeSetup;
using testing::PluginBench;

constexpr double kPeriod = 0.001;

struct TrajectoryTest : ::testing::Test {
  TrajectoryTest() {
    EXPECT_TRUE(bench.init()) << setup.failure();
    bench.start();
  }

  bool say(const std::string& words) { return plugin.on_command(words); }

  // All of them, up to the first that is refused.
  bool sayAll(std::initializer_list<const char*> lines) {
    return std::all_of(lines.begin(), lines.end(), [this](const char* line) { return say(line); });
  }

  // Cycles until the status begins so; the largest step and change of step of the first joint on the way.
  bool runUntil(std::string_view status, double seconds = 20) {
    for (int i = 0; i < seconds / kPeriod; ++i) {
      if (plugin.status().starts_with(status)) return true;
      cycle();
    }
    return plugin.status().starts_with(status);
  }

  void cycle() {
    const double before = at(0);
    bench.cycles(1);
    const double v = (at(0) - before) / kPeriod;
    fastest = std::max(fastest, std::abs(v));
    jump = std::max(jump, std::abs(v - velocity));
    velocity = v;
  }

  double at(int joint) const { return robot.joint(joint).getJointPosition(); }
  std::string status() const { return std::string(plugin.status()); }

  FakeRobot robot{3};
  FakeSetup setup{robot, ""};
  JointTrajectory plugin;
  PluginBench bench{plugin, setup};
  double fastest = 0;
  double jump = 0;
  double velocity = 0;
};

TEST_F(TrajectoryTest, GoesThroughItsPointsAndHoldsTheLast) {
  ASSERT_TRUE(sayAll({"begin", "joints j1 j2", "point 1", "positions 0.4 -0.2", "point 2", "positions 0.8 0.2", "run"}))
      << status();
  ASSERT_TRUE(runUntil("moving"));
  bench.run(1);
  EXPECT_NEAR(at(0), 0.4, 0.002);
  EXPECT_NEAR(at(1), -0.2, 0.002);
  ASSERT_TRUE(runUntil("done")) << status();
  bench.run(1);
  EXPECT_DOUBLE_EQ(at(0), 0.8);
  EXPECT_DOUBLE_EQ(at(1), 0.2);
  EXPECT_DOUBLE_EQ(at(2), 0) << "it was not named, and holds";
  EXPECT_EQ(status(), "done");
  EXPECT_EQ(bench.allocations(), 0u);
}

TEST_F(TrajectoryTest, VelocitiesMakeItCubicAndAccelerationsQuintic) {
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 1", "positions 0.3", "velocities 0.5", "point 2", "positions 0.6",
                      "velocities 0", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  for (int i = 0; i < 1000; ++i) cycle();
  EXPECT_NEAR(velocity, 0.5, 0.005);
  ASSERT_TRUE(runUntil("done"));
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 2", "positions 0", "velocities 0", "accelerations 0", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  jump = 0;
  fastest = 0;
  ASSERT_TRUE(runUntil("done"));
  EXPECT_LT(jump, 0.9 * kPeriod) << "5.77 * 0.6 / 2^2 is the greatest acceleration of a quintic";
  EXPECT_NEAR(fastest, 1.875 * 0.6 / 2, 0.002) << "and this its greatest velocity";
}

TEST_F(TrajectoryTest, PositionsAloneGoBeyondNoPoint) {
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 1", "positions 0.5", "point 3", "positions 0.6", "point 4",
                      "positions 0.1", "run"}));
  double highest = 0;
  for (int i = 0; i < 4500; ++i) {
    cycle();
    highest = std::max(highest, at(0));
  }
  EXPECT_LE(highest, 0.6 + 1e-9);
  EXPECT_DOUBLE_EQ(at(0), 0.1);
}

TEST_F(TrajectoryTest, ANewOneTakesOverWithoutAJump) {
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 2", "positions 1.2", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  for (int i = 0; i < 900; ++i) cycle();
  EXPECT_GT(velocity, 0.8);
  ASSERT_TRUE(sayAll({"begin", "joints j1 j2", "point 2", "positions 0 0.5", "run"}));
  ASSERT_TRUE(runUntil("done"));
  EXPECT_LT(jump, 0.01) << "of the velocity, in a cycle";
  EXPECT_DOUBLE_EQ(at(0), 0);
  EXPECT_DOUBLE_EQ(at(1), 0.5);
}

TEST_F(TrajectoryTest, OneThatLeavesOutWhatMovesIsRefusedAndTheOldOneGoesOn) {
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 2", "positions 1", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  bench.run(0.5);
  ASSERT_TRUE(sayAll({"begin", "joints j2", "point 2", "positions 1", "run"}));
  ASSERT_TRUE(runUntil("refused"));
  EXPECT_EQ(status(), "refused: it leaves out j1, which is moving: name it, too");
  bench.run(2);
  EXPECT_DOUBLE_EQ(at(0), 1);
}

TEST_F(TrajectoryTest, ItIsScaledByTimeOrByVelocity) {
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 1", "positions 0.4", "speed 0.5", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  bench.run(1.5);
  EXPECT_EQ(status(), "moving");
  ASSERT_TRUE(runUntil("done", 1)) << status();
  ASSERT_TRUE(
      sayAll({"begin", "joints j1", "point 0.1", "positions 1", "point 0.2", "positions -1", "velocity 0.5", "run"}));
  fastest = 0;
  ASSERT_TRUE(runUntil("done")) << status();
  EXPECT_LE(fastest, 0.5 * 1.001);
  EXPECT_GT(fastest, 0.45);
  EXPECT_DOUBLE_EQ(at(0), -1);
}

TEST_F(TrajectoryTest, StopComesToRestSmoothly) {
  ASSERT_TRUE(sayAll({"begin", "joints j1", "point 2", "positions 1.2", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  for (int i = 0; i < 900; ++i) cycle();
  ASSERT_TRUE(say("stop"));
  for (int i = 0; i < 500; ++i) cycle();
  EXPECT_EQ(status(), "stopped");
  EXPECT_DOUBLE_EQ(velocity, 0);
  EXPECT_LT(jump, 0.02);
  EXPECT_GT(at(0), 0.5);
  EXPECT_LT(at(0), 1);
}

TEST_F(TrajectoryTest, WhatIsWrongIsSaid) {
  const auto refused = [this](std::initializer_list<const char*> lines) {
    say("begin");
    if (sayAll(lines)) runUntil("refused", 1);
    return status();
  };
  EXPECT_EQ(refused({"joints j1 j9"}), "refused: 'j9' is no joint of this plugin");
  EXPECT_EQ(refused({"joints j1 j1"}), "refused: 'j1' is named twice");
  EXPECT_EQ(refused({"point 1"}), "refused: there is a point before any joint is named");
  EXPECT_EQ(refused({"joints j1", "run"}), "refused: there is no point");
  EXPECT_EQ(refused({"joints j1", "point 1", "positions 2.5"}),
            "refused: point 1 has j1 at 2.5, beyond its limits, -2 and 2");
  EXPECT_EQ(refused({"joints j1", "point 1", "positions 0", "point 1"}),
            "refused: point 2 is at 1 s, and the one before it at 1 s: times must rise");
  EXPECT_EQ(refused({"joints j1 j2", "point 1", "positions 0", "run"}),
            "refused: point 1 has 1 positions for 2 joints");
  EXPECT_EQ(refused({"joints j1", "point 1", "positions 0 1"}), "refused: point 1 has more positions than joints (1)");
  EXPECT_EQ(refused({"joints j1", "point 1", "positions nan"}), "refused: a point has what is no number: nan");
  EXPECT_EQ(
      refused({"joints j1", "point 1", "positions 0", "velocities 0", "point 2", "positions 0", "run"}),
      "refused: point 2 has other values than the first one: all must have velocities, or accelerations, or none");
  EXPECT_EQ(
      refused({"joints j1", "point 0.1", "positions 0", "point 0.2", "positions 1", "run"}),
      "refused: on the way to point 2 j1 would need 15 times its velocity limit: give it more time, or say `velocity`");
  EXPECT_EQ(refused({"joints j1", "point 5", "positions 1.9", "velocities 0.9", "point 9", "positions 1.9",
                     "velocities -0.9", "run"}),
            "refused: between the points 1 and 2 j1 would leave its limits");
  EXPECT_EQ(
      refused({"joints j1", "point 0", "positions 1", "run"}),
      "refused: it starts at once with j1 at 1, which is at 0: go there first, or give the first point some time");
  EXPECT_EQ(refused({"joints j1", "speed 2"}), "refused: the speed is 2: expected above 0 and up to 1");
  EXPECT_EQ(refused({"dance 2"}), "refused: `dance` is no word of a trajectory");
  EXPECT_FALSE(say("point 1"));
  EXPECT_EQ(status(), "refused: a trajectory starts with `begin`");
  bench.run(0.1);
  EXPECT_DOUBLE_EQ(at(0), 0) << "nothing moved";
  EXPECT_EQ(bench.allocations(), 0u);
}

TEST_F(TrajectoryTest, AJointThatIsTooFarFromItsPathEndsIt) {
  ASSERT_TRUE(sayAll({"begin", "joints j1 j2", "point 2", "positions 1 1", "path 0.1", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  bench.run(1);
  robot.put("j2", 0.2);
  bench.cycles(1);
  EXPECT_EQ(status().substr(0, 15), "aborted: j2 is ") << status();
  EXPECT_NE(status().find(" from its path"), std::string::npos);
  bench.run(1);
  EXPECT_LT(at(0), 0.9);
  EXPECT_EQ(status().substr(0, 7), "aborted");
}

TEST_F(TrajectoryTest, AJointThatDoesNotComeToItsGoalEndsIt) {
  ASSERT_TRUE(
      sayAll({"begin", "joints j1", "point 0.5", "positions 0.2", "path 0", "goal 0.01", "patience 0.3", "run"}));
  ASSERT_TRUE(runUntil("moving"));
  for (int i = 0; i < 1000 && !status().starts_with("aborted"); ++i) {
    robot.put("j1", 0.1);  // it is blocked
    bench.cycles(1);
  }
  EXPECT_EQ(status(), "aborted: j1 is 0.100 from its goal");
}

TEST_F(TrajectoryTest, ToleranceOfOneJointIsItsOwn) {
  ASSERT_TRUE(say("begin; joints j1 j2; point 2; positions 1 1; path 0; path 0.1 j2; goal 0.01 j1 j2; run"))
      << status();
  ASSERT_TRUE(runUntil("moving"));
  robot.put("j1", 0.5);
  bench.cycles(1);
  EXPECT_EQ(status(), "moving") << "of j1 it is any";
  robot.put("j2", -0.5);
  bench.cycles(1);
  EXPECT_TRUE(status().starts_with("aborted: j2 is ")) << status();
  EXPECT_FALSE(say("begin; joints j1; point 1; positions 0; path 1 j2; run"));
  EXPECT_EQ(status(), "refused: a tolerance is said of 'j2', which is not named before");
}

// ---- what a client in another process sees ----

struct ReportTest : TrajectoryTest {
  const TrajectoryReport& report() {
    bench.cycles(1);
    EXPECT_TRUE(reader.latest(newest));
    return newest;
  }
  bool reaches(TrajectoryPhase phase) {
    for (int i = 0; i < 5000 && report().phase != phase; ++i) continue;
    return newest.phase == phase;
  }

  ChannelReader<TrajectoryReport> reader{setup.channels(), trajectoryChannel("test")};
  TrajectoryReport newest{};
};

TEST_F(ReportTest, FollowsATrajectoryByItsTag) {
  EXPECT_EQ(report().phase, TrajectoryPhase::kNone);
  ASSERT_TRUE(say("@17 begin; joints j2; point 1; positions 0.5"));
  EXPECT_EQ(report().told, 17u);
  EXPECT_EQ(report().told_phase, TrajectoryPhase::kTelling);
  ASSERT_TRUE(say("@17 run"));
  ASSERT_TRUE(reaches(TrajectoryPhase::kMoving));
  EXPECT_EQ(newest.followed, 17u);
  bench.run(0.5);
  EXPECT_NEAR(report().positions[1], at(1), 0.002);
  EXPECT_NEAR(newest.seconds, 0.5, 0.01);
  EXPECT_GT(newest.velocities[1], 0.5);
  ASSERT_TRUE(reaches(TrajectoryPhase::kDone));
  EXPECT_EQ(bench.allocations(), 0u);
}

TEST_F(ReportTest, TellsARefusalBesideWhatGoesOnToItsEnd) {
  ASSERT_TRUE(say("@1 begin; joints j1; point 1; positions 0.5; run"));
  ASSERT_TRUE(reaches(TrajectoryPhase::kMoving));
  EXPECT_FALSE(say("@2 begin; joints j9"));
  EXPECT_EQ(report().told, 2u);
  EXPECT_EQ(newest.told_phase, TrajectoryPhase::kBadJoints);
  EXPECT_EQ(view(newest.refusal), "'j9' is no joint of this plugin");
  EXPECT_EQ(newest.followed, 1u);
  ASSERT_TRUE(reaches(TrajectoryPhase::kDone));
  EXPECT_EQ(newest.followed, 1u);
}

TEST_F(ReportTest, TwoWhoTellAtTheSameTimeAreNotMixed) {
  ASSERT_TRUE(say("@1 begin; joints j1"));
  ASSERT_TRUE(say("@2 begin; joints j2"));
  EXPECT_FALSE(say("@1 point 1; positions 0.3"));
  EXPECT_FALSE(say("point 1; positions 0.4"));
  EXPECT_EQ(status(), "refused: another client tells a trajectory at the same time: begin anew");
  ASSERT_TRUE(say("@2 point 1; positions 0.5; run"));
  ASSERT_TRUE(reaches(TrajectoryPhase::kDone));
  EXPECT_EQ(newest.followed, 2u);
  EXPECT_DOUBLE_EQ(at(0), 0);
  EXPECT_DOUBLE_EQ(at(1), 0.5);
}

TEST_F(ReportTest, StopEndsWhatItNames) {
  ASSERT_TRUE(say("@1 begin; joints j1; point 1; positions 0.5; run"));
  ASSERT_TRUE(reaches(TrajectoryPhase::kMoving));
  ASSERT_TRUE(say("@9 stop"));
  EXPECT_EQ(report().phase, TrajectoryPhase::kMoving);
  ASSERT_TRUE(say("@1 stop"));
  EXPECT_EQ(report().phase, TrajectoryPhase::kStopped);
  ASSERT_TRUE(say("@2 begin; joints j1; point 1; positions 0; run"));
  ASSERT_TRUE(say("stop"));
  bench.run(1);
  EXPECT_EQ(report().told_phase, TrajectoryPhase::kRefused) << "it had not begun";
  EXPECT_EQ(newest.followed, 1u);
}

TEST_F(ReportTest, TellsWhyAJointIsLostAndThatThePluginWasStopped) {
  ASSERT_TRUE(say("@1 begin; joints j1; point 1; positions 0.5; path 0.1; run"));
  ASSERT_TRUE(reaches(TrajectoryPhase::kMoving));
  robot.put("j1", 1.5);
  EXPECT_EQ(report().phase, TrajectoryPhase::kOffPath);
  EXPECT_TRUE(view(newest.ending).ends_with(" from its path")) << view(newest.ending);
  bench.run(1);
  ASSERT_TRUE(say("@2 begin; joints j1; point 1; positions 0.2; run"));
  ASSERT_TRUE(reaches(TrajectoryPhase::kMoving));
  bench.stop();
  ASSERT_TRUE(reader.latest(newest));
  EXPECT_EQ(newest.phase, TrajectoryPhase::kStopped);
}

TEST_F(TrajectoryTest, AStoppedPluginSaysThatItMustBeStarted) {
  bench.stop();
  EXPECT_FALSE(sayAll({"begin", "joints j1", "point 1", "positions 1", "run"}));
  EXPECT_EQ(status(), "refused: this plugin is stopped: start it first");
}

}  // namespace
}  // namespace robotui::rt::plugins
