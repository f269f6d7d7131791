// Whole processes: what a bad plugin, or a death, does to the others.
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>

#include <cmath>
#include <filesystem>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/relaxed.h"
#include "two_hosts.h"

namespace robotui::rt::supervisor {
namespace {

using link::Control;
using link::PluginState;

constexpr const char* kTutorial = R"(
XBotRTPlugins:
  plugins: [HomingExample, Sine, {name: log, type: Logging}, XBotCommunicationPlugin]
)";

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

TEST(Rights, OfDeadlinesAreRefusedWithTheReasonAndTheRemedyWhereTheyLack) {
  WholeConfig config = simulatedArm(kTutorial);
  const std::string type = "type: dummy";
  config.yaml.replace(config.yaml.find(type), type.size(), type + ", sched: deadline, runtime: 0.2");
  RunningRobot robot(config, {}, Rights::kNone);
  EXPECT_EQ(robot.outcome(), 3) << robot.output();
  expectIn(robot.output(), "SCHED_DEADLINE with 200 us in each 1000 us is refused: Operation not permitted.");
  expectIn(robot.output(), "AmbientCapabilities=CAP_SYS_NICE");
  expectIn(robot.output(), "--allow-non-rt");
}

bool runsByDeadline(pid_t process) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
    if (::sched_getscheduler(std::stoi(task.path().filename().string())) == SCHED_DEADLINE) return true;
  }
  return false;
}

TEST(Rights, ToDeadlinesAreUsedByThreadsOfPluginsWhereTheKernelGivesThem) {
  WholeConfig config = simulatedArm(
      "xbotcore_threads: {main: {sched: deadline, period: 0.002, runtime: 0.2}}\n"
      "xbotcore_plugins: {Sine: {thread: main, type: Sine, params: {amplitude: 0.05}}}\n",
      kPatient);
  const std::string type = "type: dummy";
  config.yaml.replace(config.yaml.find(type), type.size(), type + ", sched: deadline");
  RunningRobot robot(config);
  robot.client();
  if (robot.board()->real_time == 0) GTEST_SKIP() << "the kernel gives none here";
  ASSERT_TRUE(commands(robot, "Sine", 0)) << robot.output();
  const auto board = robot.board();
  EXPECT_EQ(board->host[0].respawns, 0U) << robot.output();
  EXPECT_TRUE(runsByDeadline(board->host[0].pid));
  EXPECT_TRUE(runsByDeadline(board->hal_pid));
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

TEST(Processes, DrivesAreNotDisabledUnderAPluginThatLeadsThem) {
  RunningRobot robot("XBotRTPlugins: {plugins: [Sine]}");
  expectOk(robot.ask("switch Sine 1"));  // waits until the robot runs
  EXPECT_EQ(robot.ctl("drives"),
            std::pair(0, std::string("The HAL of this robot has no drives that are enabled and disabled.\n")));
  expectIn(robot.ask("disable").text, "Sine leads joints: stop it before the drives are disabled.");
  expectOk(robot.ask("switch Sine 0"));
  expectOk(robot.ask("disable"));
  EXPECT_TRUE(eventually(
      [&] { return robot.output().find("has no drives that are enabled and disabled") != std::string::npos; }));
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
