#include "robotui/rt/host/plugin_thread.h"

#include <gtest/gtest.h>

#include <chrono>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/testing/fake_robot.h"

namespace robotui::rt::host {
namespace {

using link::PluginState;

// A HAL whose cycles come when the test says so.
class PluginThreadTest : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kJoints = 3;

  PluginThreadTest() {
    state_->joints = kJoints;
    writer_ = std::make_unique<link::StateWriter>(*state_, link::Counts{kJoints, 0, 0});
    state_->loop.period_ns = link::kMillisecond;
    board_writer_ = std::make_unique<link::BoardWriter>(*board_);
    environment_ = {robot_, "KDL", {RT_PLUGINS}, &directory_, master_.get(), &log_, PluginKind::kControl};
  }

  std::unique_ptr<PluginThread> makeThread(std::int64_t period_ns = link::kMillisecond) {
    auto thread =
        std::make_unique<PluginThread>(ThreadPlan{"test", 0, period_ns, 0, {}, false}, *state_, *board_, *host_);
    thread->start();
    return thread;
  }

  std::unique_ptr<HostedPlugin> makePlugin(std::uint32_t index, const std::string& params) {
    config::PluginConfig config{"plugin" + std::to_string(index), "Naughty", "test", YAML::Load(params), {}};
    return std::make_unique<HostedPlugin>(index, config, 0.001, environment_, snapshot_);
  }

  static void attach(PluginThread& thread, HostedPlugin& plugin) {
    plugin.follow(thread.frame());
    thread.attach(plugin);
  }

  void cycle() {
    auto frame = std::make_unique<link::FrameData>();
    frame->cycle = ++cycle_;
    frame->sensed_ns = link::now();
    frame->switched = switched_;
    frame->joints[0].owner = owner_;
    frame->joints[0].link_position = 0.25;
    writer_->publish(*frame);
    writer_->ring();
  }

  // Cycles until it is so; false after two seconds.
  template <typename Condition>
  bool cycleUntil(const Condition& condition) {
    for (int i = 0; i < 2000; ++i) {
      if (condition()) {
        return true;
      }
      cycle();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

  link::CommandData commands() {
    link::CommandData data{};
    link::SlotReader(*host_, 0, kJoints).read(data);
    return data;
  }

  std::shared_ptr<const config::RobotDescription> robot_ = testing::fakeDescription(kJoints);
  link::Segment<link::StateSegment> state_ = link::Segment<link::StateSegment>::create(1);
  link::Segment<link::BoardSegment> board_ = link::Segment<link::BoardSegment>::create(1);
  link::Segment<link::HostSegment> host_ = link::Segment<link::HostSegment>::create(1);
  link::Segment<link::MasterSegment> master_ = link::Segment<link::MasterSegment>::create(1);
  std::unique_ptr<ChannelSegment> channels_ = std::make_unique<ChannelSegment>();
  ChannelDirectory directory_{*channels_, {channels_.get()}};
  LogQueue log_;
  PluginEnvironment environment_;
  link::FrameData snapshot_{};
  std::unique_ptr<link::StateWriter> writer_;
  std::unique_ptr<link::BoardWriter> board_writer_;
  std::uint64_t cycle_ = 0;
  std::uint32_t switched_ = 0;  // what the HAL says of groups, and of the first joint
  std::uint16_t owner_ = link::kNobody;
};

TEST_F(PluginThreadTest, SendsTheCommandsOfAPluginThatOwnsItsJoint) {
  const auto plugin = makePlugin(5, "{joints: [j1]}");
  const auto thread = makeThread();
  EXPECT_EQ(plugin->claims(), std::vector<std::string>{"j1"});
  attach(*thread, *plugin);
  board_writer_->grant(0, 5);
  plugin->want(true);
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kRunning && commands().joints[0].mode != 0; }));
  const auto data = commands();
  EXPECT_EQ(data.joints[0].plugin, 5);
  EXPECT_DOUBLE_EQ(data.joints[0].position, 0.25);
  EXPECT_EQ(data.joints[1].mode, 0);
  plugin->want(false);
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kStopped && commands().joints[0].mode == 0; }));
  thread->detach(*plugin);
}

TEST_F(PluginThreadTest, LeavesOutJointsThatAnotherPluginOwns) {
  const auto plugin = makePlugin(5, "{joints: [j1]}");
  const auto thread = makeThread();
  attach(*thread, *plugin);
  board_writer_->grant(0, 6);
  plugin->want(true);
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kRunning && commands().cycle > 3; }));
  EXPECT_EQ(commands().joints[0].mode, 0);
  thread->detach(*plugin);
}

// Ready before, and at work in the frame that says so, in which the joint is its own; the board comes later.
TEST_F(PluginThreadTest, BeginsAndEndsWithItsGroupInTheFrameThatSaysSo) {
  const auto leaving = makePlugin(4, "{joints: [j1]}");
  const auto coming = makePlugin(5, "{joints: [j1]}");
  const auto thread = makeThread();
  attach(*thread, *leaving);
  attach(*thread, *coming);
  board_writer_->grant(0, 4);
  leaving->want(true);
  ASSERT_TRUE(cycleUntil([&] { return commands().joints[0].plugin == 4; }));
  leaving->arm(9, cycle_, false);
  coming->arm(9, cycle_, true);
  ASSERT_TRUE(cycleUntil(
      [&] { return leaving->shown() == PluginState::kStopping && coming->shown() == PluginState::kStarting; }));
  EXPECT_EQ(leaving->state(), PluginState::kRunning);
  EXPECT_EQ(commands().joints[0].plugin, 4);
  switched_ = 9;
  owner_ = 5;
  const std::uint64_t before = cycle_;
  ASSERT_TRUE(cycleUntil([&] { return commands().cycle > before; }));
  EXPECT_EQ(commands().joints[0].plugin, 5);
  EXPECT_EQ(leaving->state(), PluginState::kStopped);
  EXPECT_EQ(coming->state(), PluginState::kRunning);
  thread->detach(*leaving);
  thread->detach(*coming);
}

TEST_F(PluginThreadTest, TakesItsStartBackWhereTheGroupIsNotSwitched) {
  const auto plugin = makePlugin(5, "{joints: [j1]}");
  const auto thread = makeThread();
  attach(*thread, *plugin);
  board_writer_->grant(0, 5);
  plugin->arm(9, 0, true);
  ASSERT_TRUE(cycleUntil([&] { return plugin->shown() == PluginState::kStarting; }));
  plugin->disarm();
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kStopped; }));
  EXPECT_EQ(commands().joints[0].mode, 0);
  plugin->want(true);
  ASSERT_TRUE(cycleUntil([&] { return commands().joints[0].plugin == 5; }));
  thread->detach(*plugin);
}

TEST_F(PluginThreadTest, LosesOnlyThePluginThatThrows) {
  const auto bad = makePlugin(0, "{joints: [j1]}");
  const auto good = makePlugin(1, "{joints: [j2]}");
  const auto thread = makeThread();
  for (HostedPlugin* plugin : {bad.get(), good.get()}) {
    attach(*thread, *plugin);
    plugin->want(true);
  }
  ASSERT_TRUE(
      cycleUntil([&] { return bad->state() == PluginState::kRunning && good->state() == PluginState::kRunning; }));
  bad->order(1, "throw");
  ASSERT_TRUE(cycleUntil([&] { return bad->state() == PluginState::kFailed; }));
  EXPECT_EQ(bad->failure(), "control_loop of the plugin plugin0 threw: it was told to throw");
  const std::uint64_t before = link::relaxedLoad(host_->plugins[1].cycles);
  EXPECT_TRUE(cycleUntil([&] { return link::relaxedLoad(host_->plugins[1].cycles) > before + 3; }));
  thread->detach(*bad);
  thread->detach(*good);
}

TEST_F(PluginThreadTest, FailsAPluginWhoseLoopSaysSo) {
  const auto plugin = makePlugin(0, "{joints: [j1]}");
  const auto thread = makeThread();
  attach(*thread, *plugin);
  board_writer_->grant(0, 0);
  plugin->want(true);
  ASSERT_TRUE(cycleUntil([&] { return commands().joints[0].mode != 0; }));
  plugin->order(1, "fail");
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kFailed; }));
  EXPECT_EQ(plugin->failure(), "control_loop of the plugin plugin0 failed: it was told to fail");
  EXPECT_TRUE(cycleUntil([&] { return commands().joints[0].mode == 0; }));
  thread->detach(*plugin);
}

// Its life with commands, a status line that changes, and a failure: nothing of it asks the heap. A throw would, and is
// counted, too.
TEST_F(PluginThreadTest, AsksNothingOfTheHeapInItsCycles) {
  const auto plugin = makePlugin(0, "{joints: [j1]}");
  const auto thread = makeThread();
  attach(*thread, *plugin);
  board_writer_->grant(0, 0);
  plugin->want(true);
  ASSERT_TRUE(cycleUntil([&] { return commands().joints[0].mode != 0; }));
  plugin->order(1, "nonsense");
  HostedPlugin::Answer answer{};
  ASSERT_TRUE(cycleUntil([&] { return plugin->takeAnswer(answer); }));
  plugin->want(false);
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kStopped; }));
  plugin->want(true);
  plugin->order(2, "fail");
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kFailed; }));
  thread->stop();
  EXPECT_EQ(link::relaxedLoad(host_->thread_statistics[0].allocations), 0u);
  thread->detach(*plugin);
}

TEST_F(PluginThreadTest, CountsWhatAThrowAsksOfTheHeap) {
  const auto plugin = makePlugin(0, "{}");
  const auto thread = makeThread();
  attach(*thread, *plugin);
  plugin->want(true);
  plugin->order(1, "throw");
  ASSERT_TRUE(cycleUntil([&] { return plugin->state() == PluginState::kFailed; }));
  thread->stop();
  EXPECT_GT(link::relaxedLoad(host_->thread_statistics[0].allocations), 0u);
  thread->detach(*plugin);
}

TEST_F(PluginThreadTest, AnswersCommandsAndTellsTheStatus) {
  const auto plugin = makePlugin(0, "{}");
  const auto thread = makeThread();
  attach(*thread, *plugin);
  plugin->order(7, "nonsense");
  HostedPlugin::Answer answer{};
  ASSERT_TRUE(cycleUntil([&] { return plugin->takeAnswer(answer); }));
  EXPECT_EQ(answer.id, 7u);
  EXPECT_FALSE(answer.understood);
  HostedPlugin::Line status;
  while (plugin->takeStatus(status)) {
  }
  EXPECT_EQ(status.view(), "told");
  thread->detach(*plugin);
}

TEST_F(PluginThreadTest, RunsOnlyInItsOwnPeriod) {
  const auto plugin = makePlugin(0, "{}");
  const auto thread = makeThread(4 * link::kMillisecond);
  attach(*thread, *plugin);
  plugin->want(true);
  ASSERT_TRUE(cycleUntil([&] { return link::relaxedLoad(host_->thread_statistics[0].cycles) >= 10; }));
  EXPECT_GE(cycle_, 36u);
  thread->detach(*plugin);
}

TEST_F(PluginThreadTest, LetsGoOfAPluginWhileItCycles) {
  const auto thread = makeThread();
  for (int i = 0; i < 20; ++i) {
    const auto plugin = makePlugin(0, "{}");
    attach(*thread, *plugin);
    plugin->want(true);
    cycle();
    cycle();
    thread->detach(*plugin);
  }
  SUCCEED();
}

TEST_F(PluginThreadTest, KnowsAPluginByTheRoleThatItDeclares) {
  EXPECT_EQ(makePlugin(0, "{joints: [j1]}")->role(), PluginRole::kControl);
  const auto observer = makePlugin(0, "{observer: true, joints: [j1]}");
  EXPECT_EQ(observer->role(), PluginRole::kObserver);
  EXPECT_TRUE(observer->claims().empty());
}

TEST_F(PluginThreadTest, SaysWhyAPluginIsNotMadeReady) {
  const auto why = [&](const std::string& params) {
    try {
      makePlugin(0, params);
    } catch (const PluginError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(why("{init: throw}"), "The plugin plugin0 cannot be made ready: it was told to throw");
  EXPECT_EQ(why("{init: refuse}"), "The plugin plugin0 cannot be made ready: it was told to refuse");
  EXPECT_EQ(why("{observer: true, init: claim}"),
            "The plugin plugin0 cannot be made ready: it is an observer and claims joints; one that commands joints "
            "has another role()");
  EXPECT_NE(why("{joints: [j9]}").find("no joint 'j9'"), std::string::npos);
}

}  // namespace
}  // namespace robotui::rt::host
