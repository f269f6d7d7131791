// A plugin whose joints are in their safe state is told as such everywhere: by its state, its joints, its thread and
// the log, with the cause and the way back.
#include <gtest/gtest.h>

#include "robotui/rt/link/board.h"
#include "two_hosts.h"

namespace robotui::rt::supervisor {
namespace {

using link::Control;
using link::PluginState;

// A machine that runs tests is late now and then: ten misses are 10 ms, and each call of the sleeping one takes 5 ms,
// so that it answers none in time and comes later from frame to frame.
constexpr int kMisses = 10;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The line of a table that begins with this word.
std::string line(const std::string& table, const std::string& first) {
  const std::size_t begin = table.rfind(first + " ", 0) == 0 ? 0 : table.find("\n" + first + " ");
  if (begin == std::string::npos) return {};
  const std::size_t from = begin == 0 ? 0 : begin + 1;
  return table.substr(from, table.find('\n', from) - from);
}

class Falls : public ::testing::Test {
 protected:
  void start(int misses = kMisses, const std::string& more = {}, const std::string& hardware = {}) {
    robot_ = std::make_unique<RunningRobot>(simulatedArm(kTwoHosts + more, misses, hardware));
    ASSERT_TRUE(robot_->ask("switch bad 1").ok) << robot_->output();
  }
  RunningRobot& robot() { return *robot_; }

  void tell(const std::string& order) { robot().ask("command bad " + order); }

  bool isSafe() { return robot().frame()->joints[0].control == static_cast<std::uint8_t>(Control::kSafe); }

  // All that says something about the plugin says the same.
  void expectToldEverywhere(const std::string& state, const std::string& cause) {
    ASSERT_TRUE(eventually([&] { return has(line(robot().ctl("list").second, "bad"), cause); }))
        << robot().ctl("list").second << robot().output();
    expectIn(line(robot().ctl("list").second, "bad"), state);
    expectIn(robot().ctl("status bad").second, state + ": ");
    expectIn(robot().ctl("status bad").second, cause);
    const std::string joints = robot().ctl("joints").second;
    expectIn(line(joints, "shoulder_yaw"), "safe");
    expectIn(joints, "bad is " + state + ": ");
    expectIn(robot().ctl("loops").second, "bad " + state);
    ASSERT_TRUE(
        eventually([&] { return has(robot().output(), "To come back: ") || has(robot().output(), "To come back, "); }));
    const std::string log = robot().output();
    expectIn(log, cause);
    expectIn(log, "in cycle ");
    expectIn(log, "the joint shoulder_yaw is in its safe state");
    expectIn(log, "robotui-rt-ctl switch bad 1.");
  }

  void expectItComesBack() {
    const auto [code, said] = robot().ctl("switch bad 1");
    EXPECT_EQ(code, 0) << said;
    EXPECT_EQ(said, "bad runs.\n");
  }

 private:
  std::unique_ptr<RunningRobot> robot_;
};

TEST_F(Falls, APluginThatSleepsInItsLoopIsStoppedAndSaid) {
  start(2);
  tell("sleep");
  ASSERT_TRUE(eventually([&] { return robot().stateOf("bad") == PluginState::kStopped; })) << robot().output();
  expectToldEverywhere("stopped", "did not answer in time 2 times in turn (its thread first has 1 ms");
  expectIn(robot().output(), "bad is stopped.");
  EXPECT_TRUE(isSafe());
  expectItComesBack();
}

TEST_F(Falls, ReferencesThatAreNoNumbersAreSaidAndThenMakeItsJointsSafe) {
  start();
  tell("nan");
  ASSERT_TRUE(eventually([&] { return robot().stateOf("bad") == PluginState::kStopped; })) << robot().output();
  expectToldEverywhere("stopped", "What the plugin bad commands the joint shoulder_yaw is no number, 10 times in turn");
  expectIn(robot().output(), "is no number, in cycle ");
  expectIn(robot().output(), ": it is refused, and the joint holds.");
  expectIn(line(robot().ctl("joints").second, "shoulder_yaw"), "refused");
  expectItComesBack();
}

TEST_F(Falls, APluginThatThrewSaysWhatBecameOfItsJoints) {
  start();
  tell("throw");
  ASSERT_TRUE(eventually([&] { return robot().stateOf("bad") == PluginState::kFailed && isSafe(); }));
  ASSERT_TRUE(eventually([&] {
    return has(robot().output(),
               "Since the plugin bad failed, the joint shoulder_yaw is in "
               "its safe state");
  })) << robot().output();
  expectToldEverywhere("failed", "control_loop of the plugin bad threw: it was told to throw");
  expectIn(robot().output(), "To come back: robotui-rt-ctl reload bad, then robotui-rt-ctl switch bad 1.");
}

TEST_F(Falls, APluginWhoseProcessDiedSaysWhatBecameOfItsJoints) {
  start();
  tell("exit");
  ASSERT_TRUE(eventually([&] { return robot().stateOf("bad") == PluginState::kStopped && isSafe(); }));
  expectToldEverywhere("stopped", "The process of the host a ended by itself with code 3");
  expectItComesBack();
}

TEST_F(Falls, AnEmergencyStopIsSaidEverywhereAndNothingMovesByItselfBehindIt) {
  start(1000, "", "emergency_stops: {cell door: {}}");
  EXPECT_EQ(robot().ctl("estop").second, "cell door                 released\n");
  const auto [code, pressed] = robot().ctl("estop on cell door");
  EXPECT_EQ(code, 0) << pressed;
  expectIn(pressed, "cell door                 pressed");
  ASSERT_TRUE(eventually([&] { return robot().stateOf("bad") == PluginState::kStopped; })) << robot().output();
  expectToldEverywhere("stopped", "The emergency stop 'cell door' is pressed");
  const std::string robot_is_safe = "An emergency stop is pressed, and all joints are safe: robotui-rt-ctl estop";
  expectIn(robot().ctl("list").second, robot_is_safe);
  expectIn(robot().ctl("joints").second, robot_is_safe);
  EXPECT_TRUE(isSafe());
  const auto [refused, why] = robot().ctl("switch bad 1");
  EXPECT_EQ(refused, 1) << why;
  expectIn(why, "The emergency stop 'cell door' is pressed: nothing that leads joints can be started until");
  EXPECT_EQ(robot().ctl("estop off").second, "cell door                 released\n");
  ASSERT_TRUE(eventually([&] { return has(robot().output(), "Nothing moves by itself: start the plugins again"); }));
  EXPECT_EQ(robot().stateOf("bad"), PluginState::kStopped);
  EXPECT_TRUE(isSafe());
  expectItComesBack();
  const auto [unknown, said] = robot().ctl("estop on window");
  EXPECT_EQ(unknown, 1);
  expectIn(said, "There is no emergency stop 'window'. There are: cell door.");
}

TEST_F(Falls, AStopNeedsNoAnswerOfTheHostForTheJointToHold) {
  start(1000);
  tell("sleep");
  robot().ask("switch bad 0");
  ASSERT_TRUE(eventually([&] { return robot().stateOf("bad") == PluginState::kStopped; }));
  EXPECT_EQ(robot().errorOf("bad"), "");
  EXPECT_EQ(robot().frame()->joints[0].control, static_cast<std::uint8_t>(Control::kFree));
}

TEST_F(Falls, EveryAnswerOfTheCommandSaysWhatHappened) {
  start(1000, "  bridge: {thread: second, type: XBotCommunicationPlugin}\n");
  const auto expect = [&](const std::string& words, int code, const std::string& said) {
    const auto [got, text] = robot().ctl(words);
    EXPECT_EQ(got, code) << words << ": " << text;
    EXPECT_TRUE(has(text, said)) << words << ": " << text;
  };
  expect("reference shoulder_yaw=0.1 --for 0.1", 1,
         "Nobody follows references: bridge is stopped. Start it: "
         "robotui-rt-ctl switch bridge 1.");
  expect("reference shoulder_yaw=nan", 2, "'nan' of the reference shoulder_yaw=nan is no finite number.");
  expect("reference shoulder_yaw=inf", 2, "'inf' of the reference shoulder_yaw=inf is no finite number.");
  expect("reference shoulder_yaw=1x", 2, "is no finite number.");
  expect("reference nose=1", 2, "The robot has no joint 'nose'.");
  expect("reference", 2, "reference needs JOINT=POSITION");
  expect("reference shoulder_yaw=0.1 --for soon", 2, "'soon' of --for is no finite number.");
  expect("switch bad 0", 0, "bad is stopped.");
  expect("switch nobody 1", 1, "There is no plugin 'nobody'.");
  expect("reload bad", 0, "bad is loaded anew, and stopped.");
  expect("command good nonsense", 1, "good does not understand this.");
  expect("switch bridge 1", 0, "bridge runs.");
  expect("reference shoulder_yaw=0.01 --for 0.5", 0, "shoulder_yaw is at ");
  expect("reference shoulder_yaw=99 --for 0.1", 0, "is beyond the limits of the joint");
  expect("help", 0, "robotui-rt-ctl [--name NAME] COMMAND");
}

// Wild writes: what a plugin writes into its own memory keeps nobody from seeing and stopping the robot.
class WildWrites : public Falls, public ::testing::WithParamInterface<const char*> {};

TEST_P(WildWrites, EndTheHostAndNothingElse) {
  start(1000);
  ASSERT_TRUE(robot().ask("switch good 1").ok);
  const auto hal = robot().board()->hal_pid;
  const auto before = robot().board()->host[0].respawns;
  tell(GetParam());
  ASSERT_TRUE(eventually([&] {
    for (const char* words : {"list", "joints", "loops"}) {
      const auto [code, text] = robot().ctl(words);
      EXPECT_EQ(code, 0) << words << ": " << text;
      const bool is_text = text.find_first_of(std::string("\x1b\xff\0", 3)) == std::string::npos;
      EXPECT_TRUE(is_text) << words << ": " << text;
    }
    return robot().board()->host[0].respawns > before && robot().stateOf("bad") == PluginState::kStopped;
  })) << robot().output();
  expectIn(robot().output(), "memory was damaged (");
  expectIn(robot().errorOf("bad"), "memory was damaged (");
  EXPECT_EQ(robot().board()->hal_pid, hal);
  EXPECT_EQ(robot().stateOf("good"), PluginState::kRunning);
  EXPECT_EQ(robot().ctl("switch good 0").second, "good is stopped.\n");
  expectItComesBack();
}

INSTANTIATE_TEST_SUITE_P(Kinds, WildWrites, ::testing::Values("scribble", "fuzz"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace
}  // namespace robotui::rt::supervisor
