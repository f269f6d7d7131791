// A simulated robot that is pushed by robotui-rt-ctl: taught by hand, and bounded.
#include <gtest/gtest.h>

#include "homing.h"

namespace robotui::rt::supervisor {
namespace {

void expectRefused(const RunningRobot& robot, const std::string& words, const std::string& why) {
  const auto [code, said] = robot.ctl("push " + words);
  EXPECT_EQ(code, 1) << said;
  EXPECT_NE(said.find(why), std::string::npos) << said;
}

TEST(Pushes, AreRefusedWhereNothingGivesWay) {
  RunningRobot robot(simulatedArm(""));
  robot.client();
  expectRefused(robot, "elbow_pitch 5", "The kinematic simulation (dummy) knows no forces");
}

#ifdef RT_WITH_MUJOCO
struct PushedArm : ::testing::Test {
  PushedArm() { robot.client(); }

  double position(const std::string& joint) {
    const auto board = robot.board();
    for (std::uint32_t i = 0; i < board->joints; ++i) {
      if (link::view(board->joint[i].name) == joint) return robot.frame()->joints[i].link_position;
    }
    throw std::runtime_error("no joint " + joint);
  }

  RunningRobot robot{WholeConfig{YAML::Dump(shipped("arm", "mujoco"))}};
};

// It goes along, and stays where it is left: what is stored then is a posture.
TEST_F(PushedArm, AnArmThatFloatsIsTaughtByHand) {
  ASSERT_TRUE(robot.ask("switch GravityCompensation 1").ok);
  const double before = position("elbow_pitch");
  const auto [code, said] = robot.ctl("push elbow_pitch 6 --for 0.7");
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("elbow_pitch"), std::string::npos) << said;
  EXPECT_GT(position("elbow_pitch"), before + 0.1);
  double last = 0;
  EXPECT_TRUE(eventually([&] { return std::abs(std::exchange(last, position("elbow_pitch")) - last) < 1e-4; }));
  EXPECT_GT(last, before + 0.1);
}

// A spring tells whether it is still pushed: it comes back.
TEST_F(PushedArm, APushEndsWithItsClientAndIsBounded) {
  ASSERT_TRUE(robot.ask("switch JointImpedance 1").ok);
  const double before = position("shoulder_yaw");
  {
    link::Client client(robot.name(), std::chrono::seconds(5));
    const auto pushed = client.request("push shoulder_yaw 20 60", std::chrono::seconds(20));
    EXPECT_TRUE(pushed.ok) << pushed.text;
    EXPECT_TRUE(eventually([&] { return position("shoulder_yaw") > before + 0.08; }));
  }
  EXPECT_TRUE(eventually([&] { return position("shoulder_yaw") < before + 0.02; }));
  expectRefused(robot, "shoulder_yaw 1e6", "A push of the joint shoulder_yaw is at most ");
  expectRefused(robot, "tip 0 0 2000", "A push of a link is at most 1000 N, and not 2000.");
  expectRefused(robot, "tip 0 0 10 --for 61", "at most 60 seconds");
  expectRefused(robot, "nose 0 0 10", "The robot has no joint and no link 'nose'.");
  expectRefused(robot, "base 0 0 10", "is fixed to the world");
  expectRefused(robot, "elbow_pitch", "push needs JOINT EFFORT SECONDS");
  expectRefused(robot, "elbow_pitch x", "'x' is no finite number");
}
#endif

}  // namespace
}  // namespace robotui::rt::supervisor
