// Whole processes: what a bad plugin, or a death, does to the others.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/link/state.h"
#include "running_robot.h"

namespace robotui::rt::supervisor {
namespace {

using link::Control;
using link::PluginState;

// Two hosts: a bad plugin in one, a good one in the other.
constexpr const char* kTwoHosts = R"(
xbotcore_threads:
  first: {sched: fifo, prio: 60, period: 0.001, host: a}
  second: {sched: fifo, prio: 55, period: 0.002, host: b}
xbotcore_plugins:
  bad: {thread: first, type: Naughty, params: {joints: [shoulder_yaw]}}
  good: {thread: second, type: Naughty, params: {joints: [elbow_pitch]}}
  rival: {thread: second, type: Naughty, params: {joints: [shoulder_yaw, elbow_pitch]}}
)";

// A plugin that is late falls, and is stopped: not where that is not what is looked at.
constexpr int kPatient = 1000;
constexpr int kMisses = 20;

constexpr const char* kTutorial = R"(
XBotRTPlugins:
  plugins: [HomingExample, Sine, {name: log, type: Logging}, XBotCommunicationPlugin]
)";

void expectOk(const link::Reply& reply) { EXPECT_TRUE(reply.ok) << reply.text; }
void expectIn(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

const link::JointState& joint(const link::FrameData& frame, std::uint32_t index) { return frame.joints[index]; }

// Follows a joint frame by frame: how many cycles lie between its last command and its safe state. These are cycles of
// the HAL, whatever time each of them takes on this machine.
class Watcher {
 public:
  Watcher(const link::Attachment& attachment, std::uint32_t joint)
      : reader_(*attachment.state), joint_(joint), thread_([this] { watch(); }) {}
  ~Watcher() {
    done_ = true;
    thread_.join();
  }
  bool sawCommand() const noexcept { return commanded_ != 0; }
  bool sawSafe() const noexcept { return safe_ != 0; }
  std::uint64_t cyclesToSafe() const noexcept { return safe_ - commanded_; }
  bool sawAll() const noexcept { return !lost_; }  // since the last command

 private:
  void watch() {
    auto frame = std::make_unique<link::FrameData>();
    while (!done_ && safe_ == 0) {
      reader_.wait(link::now() + link::kMillisecond);
      while (safe_ == 0 && reader_.next(*frame) == link::Read::kNew) look(*frame);
    }
  }
  void look(const link::FrameData& frame) {
    lost_ = lost_ || reader_.lost() != known_lost_;
    known_lost_ = reader_.lost();
    const auto control = static_cast<Control>(frame.joints[joint_].control);
    if (control == Control::kCommanded) {
      commanded_ = frame.cycle;
      lost_ = false;
    }
    if (control == Control::kSafe) safe_ = frame.cycle;
  }

  link::StateReader reader_;
  std::uint32_t joint_;
  std::uint64_t known_lost_ = 0;
  std::atomic<bool> lost_{false};
  std::atomic<std::uint64_t> commanded_{0};
  std::atomic<std::uint64_t> safe_{0};
  std::atomic<bool> done_{false};
  std::thread thread_;
};

// Whether the plugin commands its joint when it is started. A machine that is late twice makes the joint safe: then it
// is started again.
bool commands(RunningRobot& robot, const std::string& plugin, std::uint32_t index) {
  return eventually([&] {
    const auto control = static_cast<Control>(joint(*robot.frame(), index).control);
    // One that fell in this moment is still being stopped.
    if (control != Control::kCommanded) robot.ask("switch " + plugin + " 1");
    return control == Control::kCommanded;
  });
}

// Tells the bad plugin to misbehave; its host dies. That the good one misses no beat is shown where time is the test's
// own: hal/answers_test.cpp.
class Misbehaviour : public ::testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  // The bad plugin commands its joint, and the watcher has seen it; false where the machine was late each time.
  static std::unique_ptr<Watcher> watched(RunningRobot& robot, const link::Attachment& attachment) {
    std::unique_ptr<Watcher> watcher;
    const bool seen = eventually([&] {
      if (!commands(robot, "bad", 0)) return false;
      watcher = std::make_unique<Watcher>(attachment, 0);
      return eventually([&] { return watcher->sawCommand() || watcher->sawSafe(); }) && !watcher->sawSafe();
    });
    return seen ? std::move(watcher) : nullptr;
  }
};

TEST_P(Misbehaviour, LosesItsHostAloneWhichComesBackWhileItsJointIsSafe) {
  const auto [order, sentence] = GetParam();
  RunningRobot robot(simulatedArm(kTwoHosts, kMisses));
  expectOk(robot.ask("switch good 1"));
  const auto board = robot.board();
  const auto attachment = robot.attach();
  const auto watcher = watched(robot, attachment);
  ASSERT_TRUE(watcher) << robot.output();
  robot.ask(std::string("command bad ") + order);
  ASSERT_TRUE(eventually([&] { return watcher->sawSafe(); }));
  if (watcher->sawAll()) {
    EXPECT_LE(watcher->cyclesToSafe(), kMisses + 1U);  // the misses hold, and it is safe in the next cycle
  }
  ASSERT_TRUE(eventually([&] {
    return robot.board()->host[0].respawns == 1 && robot.stateOf("bad") == PluginState::kStopped;
  })) << robot.output();
  expectIn(robot.errorOf("bad"), sentence);
  EXPECT_EQ(joint(*robot.frame(), 0).control, static_cast<std::uint8_t>(Control::kSafe));
  EXPECT_EQ(robot.board()->host[1].pid, board->host[1].pid);
  EXPECT_EQ(robot.board()->hal_pid, board->hal_pid);
  EXPECT_TRUE(commands(robot, "good", 3));
  EXPECT_TRUE(commands(robot, "bad", 0));
}

INSTANTIATE_TEST_SUITE_P(Kinds, Misbehaviour,
                         ::testing::Values(std::pair{"crash", "signal 11 (Segmentation fault) in the plugin bad."},
                                           std::pair{"exit", "ended by itself with code 3 in the plugin bad."},
                                           std::pair{"spin", "in the plugin bad."}),
                         [](const auto& kind) { return std::string(kind.param.first); });

TEST(Processes, AThrowingPluginFailsAloneAndCanBeReloaded) {
  RunningRobot robot(simulatedArm(kTwoHosts, kPatient));
  expectOk(robot.ask("switch bad 1"));
  robot.ask("command bad throw");
  ASSERT_TRUE(eventually([&] { return robot.stateOf("bad") == PluginState::kFailed; }));
  expectIn(robot.errorOf("bad"), "control_loop of the plugin bad threw: it was told to throw");
  EXPECT_EQ(robot.board()->host[0].respawns, 0u);
  expectIn(robot.ask("switch bad 1").text, "must be reloaded first");
  expectOk(robot.ask("reload bad"));
  expectOk(robot.ask("switch bad 1"));
}

TEST(Processes, APluginWhoseLoopSaysThatItFailedFailsAlone) {
  RunningRobot robot(simulatedArm(kTwoHosts, kPatient));
  expectOk(robot.ask("switch bad 1"));
  robot.ask("command bad fail");
  ASSERT_TRUE(eventually([&] { return robot.stateOf("bad") == PluginState::kFailed; }));
  expectIn(robot.errorOf("bad"), "control_loop of the plugin bad failed: it was told to fail");
  EXPECT_EQ(robot.board()->host[0].respawns, 0u);
  expectOk(robot.ask("reload bad"));
}

TEST(Processes, WhoScribblesOverItsSegmentHarmsNobodyElse) {
  RunningRobot robot(simulatedArm(kTwoHosts, kPatient));
  expectOk(robot.ask("switch bad 1"));
  expectOk(robot.ask("switch good 1"));
  robot.ask("command bad scribble");
  const auto before = robot.frame()->cycle;
  EXPECT_TRUE(eventually([&] { return robot.frame()->cycle > before + 200; }));
  const auto frame = robot.frame();
  EXPECT_NEAR(joint(*frame, 0).link_position, 0, 4);
  EXPECT_TRUE(std::isfinite(joint(*frame, 0).position_reference));
  EXPECT_EQ(robot.stateOf("good"), PluginState::kRunning);
}

TEST(Processes, AJointHasOneOwner) {
  RunningRobot robot(simulatedArm(kTwoHosts, kPatient));
  expectOk(robot.ask("switch bad 1"));
  const auto refused = robot.ask("switch rival 1");
  EXPECT_FALSE(refused.ok);
  EXPECT_EQ(refused.text,
            "rival cannot be started while bad runs: both command the joint shoulder_yaw. Stop bad first.");
  expectOk(robot.ask("switch bad 0"));
  expectOk(robot.ask("switch rival 1"));
}

TEST(Processes, APluginThatCannotBeLoadedSaysWhyAndTheOthersRun) {
  RunningRobot robot(
      "XBotRTPlugins: {plugins: [{name: p, type: Missing}, {name: q, type: WrongAbi}, {name: r, type: "
      "ThrowingConstructor},"
      " {name: s, type: Naughty, params: {joints: [nose]}}, {name: t, type: Naughty, params: {init: throw}}, Sine]}");
  expectIn(robot.errorOf("p"), "There is no libMissing.so in ");
  expectIn(robot.errorOf("q"), "version 999");
  expectIn(robot.errorOf("r"), "no hardware key");
  expectIn(robot.errorOf("s"), "no joint 'nose'");
  expectIn(robot.errorOf("t"), "it was told to throw");
  expectOk(robot.ask("switch Sine 1"));
}

TEST(Processes, APluginThatCrashesWhileItIsMadeReadyIsLeftOut) {
  RunningRobot robot("XBotRTPlugins: {plugins: [{name: killer, type: Naughty, params: {init: crash}}, Sine]}");
  ASSERT_TRUE(eventually([&] { return robot.stateOf("killer") == PluginState::kFailed; })) << robot.output();
  expectIn(robot.errorOf("killer"), "again and again while it was made ready");
  expectOk(robot.ask("switch Sine 1"));
}

TEST(Processes, AHostThatDiesAgainAndAgainIsLeftAloneUntilAPluginOfItIsReloaded) {
  RunningRobot robot(kTwoHosts);
  const auto isLeftAlone = [&] { return robot.stateOf("bad") == PluginState::kFailed; };
  for (int deaths = 0; deaths < 20 && !isLeftAlone(); ++deaths) {
    ASSERT_TRUE(eventually([&] { return isLeftAlone() || robot.stateOf("bad") == PluginState::kStopped; }))
        << robot.output();
    const auto pid = robot.board()->host[0].pid;
    if (pid > 0) ::kill(pid, SIGKILL);
    ASSERT_TRUE(eventually([&] { return robot.board()->host[0].pid != pid; })) << robot.output();
  }
  ASSERT_TRUE(isLeftAlone());
  expectIn(robot.errorOf("bad"), "It died again and again and is not started any more");
  expectOk(robot.ask("reload bad"));
  expectOk(robot.ask("switch bad 1"));
}

TEST(Processes, AnIoPluginThatCrashesTakesNobodyWithIt) {
  RunningRobot robot(simulatedArm("XBotRTPlugins: {plugins: [Sine], io_plugins: [Greeter]}", kPatient));
  EXPECT_TRUE(eventually([&] { return robot.ask("status Greeter").text == "running: running"; }));
  expectOk(robot.ask("switch Sine 1"));
  robot.ask("command Greeter crash");
  EXPECT_TRUE(eventually([&] {
    return robot.board()->host[1].respawns == 1 && robot.stateOf("Greeter") == PluginState::kRunning;
  })) << robot.output();
  EXPECT_EQ(robot.stateOf("Sine"), PluginState::kRunning);
}

TEST(Processes, AllRunInOrdinaryThreadsWhereThatIsAskedFor) {
  RunningRobot robot("XBotRTPlugins: {plugins: [Sine]}", {"--nrt"});
  expectOk(robot.ask("switch Sine 1"));
  const auto attachment = robot.attach();
  EXPECT_EQ(robot.board()->real_time, 0u);
  EXPECT_EQ(link::relaxedLoad(attachment.state->loop.priority), 0);
  EXPECT_EQ(link::relaxedLoad(attachment.hosts[0]->thread_statistics[0].priority), 0);
}

// However late they are: that others have the processor is no matter of this test.
TEST(Processes, PluginsRunInOrdinaryThreadsUnchanged) {
  RunningRobot robot(simulatedArm("NRTPlugins: {plugins: [Sine]}", 1000));
  EXPECT_TRUE(eventually([&] {
    commands(robot, "Sine", 1);
    return std::abs(joint(*robot.frame(), 1).link_position) > 0.001;
  }));
}

TEST(Processes, AKilledHalComesBackAndNothingMovesByItself) {
  RunningRobot robot(kTwoHosts);
  expectOk(robot.ask("switch good 1"));
  const auto pid = robot.board()->hal_pid;
  ::kill(pid, SIGKILL);
  ASSERT_TRUE(eventually([&] {
    return robot.board()->hal_respawns == 1 && robot.stateOf("good") == PluginState::kStopped;
  })) << robot.output();
  EXPECT_NE(robot.board()->hal_pid, pid);
  expectOk(robot.ask("switch good 1"));
}

TEST(Processes, AllEndWithTheSupervisor) {
  RunningRobot robot(kTwoHosts);
  const auto board = robot.board();
  EXPECT_EQ(robot.end(SIGKILL), 128 + SIGKILL);
  for (const auto pid : {board->hal_pid, board->host[0].pid, board->host[1].pid}) {
    EXPECT_TRUE(eventually([&] { return ::kill(pid, 0) != 0; })) << pid;
  }
}

TEST(Processes, EndInOrderAndLeaveNoSocket) {
  RunningRobot robot(kTwoHosts);
  expectOk(robot.ask("switch bad 1"));
  EXPECT_EQ(robot.end(SIGINT), 0) << robot.output();
  EXPECT_FALSE(std::filesystem::exists(link::socketPath(robot.name())));
}

TEST(Processes, ASecondOneOfTheSameNameIsRefused) {
  RunningRobot robot(kTwoHosts);
  robot.client();
  const auto [code, output] = robot.second();
  EXPECT_EQ(code, 1);
  expectIn(output, "robotui-rt: ");
  EXPECT_EQ(robot.stateOf("bad"), PluginState::kStopped);
}

// The tutorial of the paper: homing on, off, the communication plugin on, a reference moves the joint.
TEST(Processes, FollowTheTutorialOfThePaper) {
  RunningRobot robot(simulatedArm(kTutorial, 1000), {"-D", "--allow-non-rt"});
  expectOk(robot.ask("switch log 1"));
  expectOk(robot.ask("switch HomingExample 1"));
  ASSERT_TRUE(eventually([&] { return robot.ask("status HomingExample").text == "running: at home"; }))
      << robot.ask("status HomingExample").text;
  expectIn(robot.ask("switch XBotCommunicationPlugin 1").text,
           "cannot be started while other plugins run (HomingExample)");
  expectOk(robot.ask("switch HomingExample 0"));
  expectOk(robot.ask("switch XBotCommunicationPlugin 1"));
  expectIn(robot.ask("switch Sine 1").text, "cannot be started while XBotCommunicationPlugin runs");
  expectOk(robot.ask("take 2"));
  std::vector<link::JointCommand> commands(robot.board()->joints);
  commands[0].position = 0.5;
  commands[0].mode = link::kPosition;
  EXPECT_TRUE(eventually([&] {
    robot.client().reference(commands);
    return std::abs(joint(*robot.frame(), 0).link_position - 0.5) < 0.01;
  }));
  expectOk(robot.ask("release"));
  EXPECT_NEAR(joint(*robot.frame(), 0).position_reference, 0.5, 0.01);
}

// As XBot does it: the framework that the configuration names commands, all others look on.
TEST(Processes, OnlyTheMasterFrameworkCommands) {
  RunningRobot workbench("XBotRTPlugins: {plugins: [XBotCommunicationPlugin]}");
  expectOk(workbench.ask("take 2"));
  expectOk(workbench.ask("release"));
  expectOk(workbench.ask("take 2 robotui"));
  expectOk(workbench.ask("release"));
  expectIn(workbench.ask("take 2 ROS").text,
           "The master framework of this robot is robotui: references of ROS do not count.");

  RunningRobot ros(
      "XBotRTPlugins: {plugins: [XBotCommunicationPlugin]}\nMasterCommunicationInterface: {framework_name: ROS}");
  expectOk(ros.ask("take 2 ROS"));
  expectOk(ros.ask("release"));
  expectIn(ros.ask("take 2").text, "The master framework of this robot is ROS: references of robotui do not count.");
  expectOk(ros.ask("switch XBotCommunicationPlugin 1"));
}

TEST(Rights, AreRefusedWithTheReasonAndTheRemedyWhereTheyLack) {
  RunningRobot robot(kTutorial, {}, Rights::kNone);
  EXPECT_EQ(robot.outcome(), 3) << robot.output();
  expectIn(robot.output(),
           "This process may not run in real time: priority 90 of SCHED_FIFO is refused (Operation not permitted).");
  expectIn(robot.output(), "/etc/security/limits.d");
  expectIn(robot.output(), "--allow-non-rt");
}

TEST(Rights, AreDoneWithoutWhereThatIsAllowedAndTheStateSaysSo) {
  RunningRobot robot(kTutorial, {"--allow-non-rt"}, Rights::kNone);
  expectOk(robot.ask("switch Sine 1"));
  EXPECT_EQ(robot.board()->real_time, 0U);
  const auto attachment = robot.attach();
  EXPECT_EQ(link::relaxedLoad(attachment.state->loop.priority), 0);
  EXPECT_EQ(link::relaxedLoad(attachment.hosts[0]->thread_statistics[0].priority), 0);
  expectIn(robot.output(), "goes on without (--allow-non-rt): cycles will come late.");
}

// In pieces, as a client reads them.
std::string told(RunningRobot& robot, const std::string& which) {
  std::string text;
  for (std::string offset = "0";;) {
    const auto reply = robot.ask("describe " + which + " " + offset);
    expectOk(reply);
    const auto end = reply.text.find(' ');
    if (!reply.ok || end == std::string::npos) return text;
    text += reply.text.substr(end + 1);
    offset = reply.text.substr(0, end);
    if (offset == "0") return text;
    EXPECT_EQ(offset, std::to_string(text.size()));
  }
}

TEST(Processes, TellWhatTheRobotIsMadeOf) {
  RunningRobot robot("XBotRTPlugins: {plugins: [XBotCommunicationPlugin]}");
  for (const char* which : {"urdf", "srdf"}) {
    const auto text = told(robot, which);
    expectIn(text, "<robot ");
    expectIn(text, "</robot>");
    const auto cut = robot.ask("describe " + std::string(which) + " " + std::to_string(text.find("</robot>")));
    EXPECT_EQ(cut.text.substr(0, 10), "0 </robot>");
  }
  EXPECT_TRUE(robot.ask("describe urdf 999999999").ok);
}

TEST(Processes, HostileRequestsGetSentences) {
  RunningRobot robot(kTwoHosts);
  for (const char* words :
       {"",        "dance", "switch",   "switch bad",    "switch bad 2",    "switch nobody 1",  "reload",
        "command", "take",  "take -1",  "take inf",      "take 1e99",       "release",          "status nobody",
        "begin",   "end",   "describe", "describe urdf", "describe mesh 0", "describe urdf -1", "describe urdf 1x"}) {
    const auto reply = robot.ask(words);
    EXPECT_FALSE(reply.ok) << words;
    EXPECT_GT(reply.text.size(), 15u) << words;
  }
  EXPECT_FALSE(robot.ask(std::string(60000, 'x')).ok);
  EXPECT_EQ(robot.stateOf("bad"), PluginState::kStopped);
}

}  // namespace
}  // namespace robotui::rt::supervisor
