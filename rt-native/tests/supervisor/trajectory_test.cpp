// A file of points by robotui-rt-ctl, in the arm as it is shipped: with its own limits of acceleration and jerk.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "homing.h"

namespace robotui::rt::supervisor {
namespace {

struct Trajectories : ::testing::Test {
  Trajectories() { robot.client(); }

  std::pair<int, std::string> run(const std::string& yaml) const {
    const auto file = robot.config().parent_path() / "points.yaml";
    std::ofstream(file) << yaml;
    return robot.ctl("trajectory " + file.string());
  }

  RunningRobot robot{WholeConfig{YAML::Dump(shipped("arm", "dummy"))}};
};

TEST_F(Trajectories, OfAFileAreGoneThroughAndHeldAtTheEnd) {
  ASSERT_TRUE(robot.ask("switch JointTrajectory 1").ok);
  const auto [code, said] = run(R"(
joint_names: [shoulder_yaw, elbow_pitch]
points:
  - {positions: [0.3, 0.2], time_from_start: 0.4}
  - {positions: [0.5, 0.4], time_from_start: {secs: 0, nsecs: 800000000}}
velocity: 0.5
)");
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("JointTrajectory is running: done"), std::string::npos) << said;
  EXPECT_TRUE(eventually([&] { return farthest(robot, {{"shoulder_yaw", 0.5}, {"elbow_pitch", 0.4}}) < kNear; }));
}

// For clients that read no channels.
TEST_F(Trajectories, AreToldAsWords) {
  EXPECT_FALSE(robot.ask("trajectory Nobody").ok);
  ASSERT_TRUE(robot.ask("switch JointTrajectory 1").ok);
  const std::string words = "@7 begin;joints elbow_pitch;point 0.2;positions 0.1;run";
  ASSERT_TRUE(robot.ask("command JointTrajectory " + words).ok);
  std::string said;
  EXPECT_TRUE(eventually([&] {
    said = robot.ask("trajectory JointTrajectory").text;
    return said.starts_with("7 moving 7 done ") || said.starts_with("7 done 7 done ");
  })) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 5) << said;
  robot.ask("command JointTrajectory @8 begin;joints tail");
  EXPECT_TRUE(eventually([&] {
    said = robot.ask("trajectory JointTrajectory").text;
    return said.starts_with("8 bad_joints 7 done ") && said.find("tail") != std::string::npos;
  })) << said;
}

TEST_F(Trajectories, ThatCannotBeSayWhy) {
  const auto stopped = run("joint_names: [elbow_pitch]\npoints: [{positions: [0.1], time_from_start: 1}]\n");
  EXPECT_EQ(stopped.first, 1);
  EXPECT_NE(stopped.second.find("this plugin is stopped: start it first"), std::string::npos) << stopped.second;
  ASSERT_TRUE(robot.ask("switch JointTrajectory 1").ok);
  const auto beyond = run("joint_names: [elbow_pitch]\npoints: [{positions: [9], time_from_start: 1}]\n");
  EXPECT_EQ(beyond.first, 1);
  EXPECT_NE(beyond.second.find("beyond its limits"), std::string::npos) << beyond.second;
  const auto misspelt = run("joint_names: [elbow_pitch]\npoint: []\n");
  EXPECT_EQ(misspelt.first, 1);
  EXPECT_NE(misspelt.second.find("did you mean 'points'?"), std::string::npos) << misspelt.second;
}

}  // namespace
}  // namespace robotui::rt::supervisor
