// Groups of plugins in whole processes: all is switched in one cycle of the HAL, or nothing is, and it is said why.
#include <gtest/gtest.h>
#include <signal.h>

#include <future>
#include <vector>

#include "robotui/rt/link/board.h"
#include "two_hosts.h"

namespace robotui::rt::supervisor {
namespace {

using link::Control;
using link::PluginState;

constexpr const char* kGroups = R"(
switch_groups:
  one: {start: [rival], stop: [bad, good]}
  two: {start: [bad, good], stop: [rival]}
)";

WholeConfig twoHosts() { return simulatedArm(std::string(kTwoHosts) + kGroups, kPatient); }

// The frames of the last group that was switched and of the one before, from the oldest on that is there.
std::vector<link::FrameData> frames(RunningRobot& robot) {
  const auto attachment = robot.attach();
  link::StateReader reader(*attachment.state);
  std::vector<link::FrameData> all;
  auto frame = std::make_unique<link::FrameData>();
  const std::uint64_t newest = robot.frame()->cycle;
  while (all.empty() || all.back().cycle < newest) {
    if (reader.next(*frame) == link::Read::kNew) all.push_back(*frame);
    if (!all.empty() && all.back().switched == 0) all.pop_back();
  }
  return all;
}

std::uint16_t ownerIn(const link::FrameData& frame, std::uint32_t joint) { return frame.joints[joint].owner; }

struct Joints {
  std::uint32_t first;
  std::uint32_t second;
};

Joints jointsOf(RunningRobot& robot) {
  const auto board = robot.board();
  Joints joints{};
  for (std::uint32_t i = 0; i < board->joints; ++i) {
    if (link::view(board->joint[i].name) == "shoulder_yaw") joints.first = i;
    if (link::view(board->joint[i].name) == "elbow_pitch") joints.second = i;
  }
  return joints;
}

void expectRunning(RunningRobot& robot, const std::vector<std::string>& plugins) {
  for (const std::string name : {"bad", "good", "rival"}) {
    const bool runs = std::find(plugins.begin(), plugins.end(), name) != plugins.end();
    EXPECT_TRUE(eventually([&] {
      return robot.stateOf(name) == (runs ? PluginState::kRunning : PluginState::kStopped);
    })) << name
        << " " << robot.errorOf(name) << robot.output();
  }
}

// Two plugins of two processes are followed by a third one: in no frame has a joint nobody, or another owner than its
// neighbour of the same group.
TEST(Groups, AreSwitchedInOneCycleOfAllHostsWithoutAJointThatNobodyHolds) {
  RunningRobot robot(twoHosts());
  robot.client();
  const auto started = robot.ctl("switch bad 1 good 1");
  EXPECT_EQ(started.first, 0) << started.second;
  expectIn(started.second, "In cycle ");
  expectIn(started.second, " bad runs, good runs.");
  const Joints joints = jointsOf(robot);
  const std::uint32_t rival = robot.plugin("rival");
  const auto swapped = robot.ask("switch bad 0 good 0 rival 1");
  ASSERT_TRUE(swapped.ok) << swapped.text;
  const std::uint64_t cycle = std::stoull(swapped.text.substr(std::string("In cycle ").size()));
  for (const link::FrameData& frame : frames(robot)) {
    const bool is_switched = frame.cycle >= cycle;
    EXPECT_EQ(frame.switched, is_switched ? 2u : 1u) << "in cycle " << frame.cycle;
    for (const std::uint32_t each : {joints.first, joints.second}) {
      const std::uint16_t owner = ownerIn(frame, each);
      EXPECT_EQ(owner == rival, is_switched) << "in cycle " << frame.cycle;
      EXPECT_NE(owner, link::kNobody) << "in cycle " << frame.cycle;
      EXPECT_NE(joint(frame, each).control, static_cast<std::uint8_t>(Control::kSafe)) << "in cycle " << frame.cycle;
      EXPECT_EQ(joint(frame, each).rejected, 0u);
    }
  }
  expectRunning(robot, {"rival"});
  EXPECT_EQ(robot.ctl("group two").first, 0);
  expectRunning(robot, {"bad", "good"});
  expectIn(robot.ctl("group").second, "starts rival stops bad, good");
  expectIn(robot.ctl("group two").second, "Nothing is to be done");
}

TEST(Groups, ARefusalNamesThePluginAndLeavesAllAsItWas) {
  RunningRobot robot(twoHosts());
  expectOk(robot.ask("switch bad 1"));
  const auto refused = [&](const std::string& words, const std::string& why) {
    const auto reply = robot.ask(words);
    EXPECT_FALSE(reply.ok) << reply.text;
    expectIn(reply.text, why);
  };
  refused("switch good 1 rival 1",
          "Nothing was switched: good and rival cannot run together: both command the joint elbow_pitch.");
  refused("switch rival 1 good 0",
          "rival cannot be started while bad runs: both command the joint shoulder_yaw. Stop bad first.");
  refused("switch good 1 nobody 1", "There is no plugin 'nobody'");
  refused("switch good 1 good 0", "good is there twice");
  refused("switch good 1 bad yes", "not 'yes' behind bad");
  refused("group three", "There is no group 'three' in switch_groups of the configuration. There are: one, two.");
  robot.ask("command rival refuse");
  refused("switch bad 0 rival 1",
          "Nothing was switched: rival is failed: on_start of the plugin rival failed: it was told to refuse");
  EXPECT_EQ(robot.stateOf("bad"), PluginState::kRunning);
  EXPECT_EQ(robot.stateOf("good"), PluginState::kStopped);
  EXPECT_EQ(ownerIn(*robot.frame(), jointsOf(robot).first), robot.plugin("bad"));
  refused("switch bad 0 rival 1", "must be reloaded first");
}

// It does not get ready, since it stands still; what leads the joint goes on.
TEST(Groups, AHostThatIsKilledInTheMiddleHalfSwitchesNothing) {
  RunningRobot robot(twoHosts());
  expectOk(robot.ask("switch bad 1"));
  const pid_t host = robot.board()->host[1].pid;
  ::kill(host, SIGSTOP);
  auto asked = std::async(std::launch::async, [&] { return robot.ctl("switch bad 0 rival 1"); });
  EXPECT_TRUE(eventually([&] { return robot.stateOf("rival") != PluginState::kStopped; })) << robot.output();
  ::kill(host, SIGKILL);
  const auto [code, said] = asked.get();
  EXPECT_EQ(code, 1);
  expectIn(said, "Nothing was switched: rival ");
  EXPECT_EQ(robot.stateOf("bad"), PluginState::kRunning);
  EXPECT_EQ(ownerIn(*robot.frame(), jointsOf(robot).first), robot.plugin("bad"));
  ASSERT_TRUE(eventually([&] { return robot.stateOf("rival") == PluginState::kStopped; }));
  expectOk(robot.ask("switch bad 0 rival 1"));
  expectRunning(robot, {"rival"});
}

// A stop is never kept waiting: it ends the group.
TEST(Groups, AStopOfAPluginThatIsBeingSwitchedEndsTheGroup) {
  RunningRobot robot(twoHosts());
  expectOk(robot.ask("switch bad 1"));
  const pid_t host = robot.board()->host[1].pid;
  ::kill(host, SIGSTOP);
  auto asked = std::async(std::launch::async, [&] { return robot.ctl("switch bad 0 rival 1"); });
  EXPECT_TRUE(eventually([&] { return robot.stateOf("rival") != PluginState::kStopped; })) << robot.output();
  expectOk(robot.ask("switch bad 0"));
  expectIn(asked.get().second, "Nothing was switched: ");
  ::kill(host, SIGCONT);
  const std::uint32_t first = jointsOf(robot).first;
  EXPECT_TRUE(eventually([&] { return ownerIn(*robot.frame(), first) == link::kNobody; }));
}

// By themselves the reader would fail in its first cycle; together both begin in the same one.
TEST(Groups, PluginsThatFeedOneAnotherBeginInTheSameCycle) {
  RunningRobot robot(simulatedArm(R"(
XBotRTPlugins:
  plugins:
    - {name: feeder, type: Chained, params: {channel: chain, feeds: true}}
    - {name: fed, type: Chained, params: {channel: chain, feeds: false, joints: [elbow_pitch]}}
    - {name: lonely, type: Chained, params: {channel: chain, feeds: false}}
)",
                                  kPatient));
  robot.ask("switch lonely 1");
  EXPECT_TRUE(eventually([&] { return robot.stateOf("lonely") == PluginState::kFailed; }));
  expectIn(robot.errorOf("lonely"), "nobody feeds it in this cycle");
  for (int i = 0; i < 3; ++i) {
    expectOk(robot.ask("switch fed 1 feeder 1"));
    const auto before = robot.frame()->cycle;
    EXPECT_TRUE(eventually([&] { return robot.frame()->cycle > before + 100; }));
    EXPECT_EQ(robot.stateOf("fed"), PluginState::kRunning) << robot.errorOf("fed");
    expectOk(robot.ask("switch fed 0 feeder 0"));
    EXPECT_TRUE(eventually([&] { return robot.stateOf("fed") == PluginState::kStopped; })) << robot.errorOf("fed");
    EXPECT_TRUE(eventually([&] { return robot.stateOf("feeder") == PluginState::kStopped; }));
  }
}

}  // namespace
}  // namespace robotui::rt::supervisor
