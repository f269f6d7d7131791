// What a plugin that takes its host with it does to its own joint, and to the others.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "two_hosts.h"

namespace robotui::rt::supervisor {
namespace {

using link::Control;
using link::PluginState;

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
  RunningRobot robot(simulatedArm(kTwoHosts, kPatient));
  expectOk(robot.ask("switch good 1"));
  const auto board = robot.board();
  const auto attachment = robot.attach();
  const auto watcher = watched(robot, attachment);
  ASSERT_TRUE(watcher) << robot.output();
  robot.ask(std::string("command bad ") + order);
  ASSERT_TRUE(eventually([&] { return watcher->sawSafe(); }));
  ASSERT_TRUE(eventually([&] {
    return robot.board()->host[0].respawns == 1 && robot.stateOf("bad") == PluginState::kStopped;
  })) << robot.output();
  expectIn(robot.errorOf("bad"), sentence);
  EXPECT_EQ(joint(*robot.frame(), 0).control, static_cast<std::uint8_t>(Control::kSafe));
  EXPECT_EQ(robot.stateOf("good"), PluginState::kRunning);
  EXPECT_EQ(robot.board()->host[1].pid, board->host[1].pid);
  EXPECT_EQ(robot.board()->hal_pid, board->hal_pid);
  EXPECT_TRUE(commands(robot, "good", 3));
  EXPECT_TRUE(commands(robot, "bad", 0));
}

// Two misses are what a robot has that says nothing of it.
TEST_P(Misbehaviour, MakesItsJointSafeWithinThreeCycles) {
  RunningRobot robot(kTwoHosts);
  const auto attachment = robot.attach();
  const auto watcher = watched(robot, attachment);
  ASSERT_TRUE(watcher) << robot.output();
  robot.ask(std::string("command bad ") + GetParam().first);
  ASSERT_TRUE(eventually([&] { return watcher->sawSafe(); }));
  if (watcher->sawAll()) {
    EXPECT_LE(watcher->cyclesToSafe(), 3U);  // two misses, which hold, and safe in the next cycle
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Misbehaviour,
                         ::testing::Values(std::pair{"crash", "signal 11 (Segmentation fault) in the plugin bad."},
                                           std::pair{"exit", "ended by itself with code 3 in the plugin bad."},
                                           std::pair{"spin", "in the plugin bad."}),
                         [](const auto& kind) { return std::string(kind.param.first); });

}  // namespace
}  // namespace robotui::rt::supervisor
