// What a cycle tells of joints: which fell, when and why, each once.
#include "cycle.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "rig.h"
#include "robotui/rt/link/allocations.h"

namespace robotui::rt::hal {
namespace {

using link::Control;
using link::FallCause;
using link::Objection;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct FallsTest : testing::Test, Rig {
  // The plugin owns the joints and commanded them in the last cycle.
  void commanding(std::uint16_t plugin = 0) {
    run();
    grantAll(plugin);
    command(position(0), plugin);
    run();
  }
  std::vector<link::JointEvent> told() {
    std::vector<link::JointEvent> events;
    for (link::JointEvent event; cycle->takeEvent(event);) events.push_back(event);
    return events;
  }
};

TEST_F(FallsTest, a_thread_that_falls_silent_is_told_once_with_its_joints_and_its_cycle) {
  commanding();
  run();
  EXPECT_TRUE(told().empty()) << "one miss only holds";
  run();
  const auto events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, FallCause::kMissed);
  EXPECT_EQ(events[0].plugin, 0);
  EXPECT_EQ(events[0].cycle, number);
  EXPECT_EQ(events[0].grant, 1U);
  EXPECT_EQ(events[0].joints.count(), 3U);
  for (int i = 0; i < 100; ++i) run();
  EXPECT_TRUE(told().empty());
}

TEST_F(FallsTest, what_is_no_number_is_told_at_once_and_falls_when_it_comes_again) {
  commanding();
  command(position(kNaN));
  run();
  auto events = told();
  ASSERT_EQ(events.size(), 3U) << "each joint";
  EXPECT_EQ(events[0].cause, FallCause::kNone);
  EXPECT_EQ(events[0].objection, Objection::kNoNumber);
  EXPECT_EQ(events[0].rejected, 1U);
  command(position(kNaN));
  run();
  events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, FallCause::kRejected);
  EXPECT_EQ(events[0].objection, Objection::kNoNumber);
  EXPECT_EQ(control(), Control::kSafe);
}

TEST_F(FallsTest, a_command_that_is_refused_now_and_then_falls_never_and_is_not_told_in_every_cycle) {
  commanding();
  std::size_t count = 0;
  for (int i = 0; i < 100; ++i) {
    command(position(i % 2 == 0 ? kNaN : 0));
    run();
    count += told().size();
  }
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(control(), Control::kCommanded);
}

TEST_F(FallsTest, one_answer_of_a_slow_thread_is_counted_once) {
  run();
  grantAll(1);
  command(position(kNaN), 1);
  for (int i = 0; i < 9; ++i) run();
  EXPECT_NE(control(), Control::kSafe);
}

TEST_F(FallsTest, a_plugin_falls_as_a_whole) {
  commanding();
  for (int i = 0; i < 2; ++i) {
    link::CommandData data{};
    data.cycle = number + 1;
    for (auto& joint : data.joints) joint = position(0);
    data.joints[1].position = kNaN;
    link::SlotWriter(*host, 0, kJoints).write(data);
    run();
  }
  run();
  for (const std::size_t joint : {0U, 1U, 2U}) {
    EXPECT_EQ(frame().joints[joint].control, static_cast<std::uint8_t>(Control::kSafe)) << joint;
  }
  const auto events = told();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].joint, 1);
  EXPECT_EQ(events[1].joints.count(), 3U);
}

TEST_F(FallsTest, plugins_fall_each_by_itself) {
  run();
  grants.grant(0, 0);
  grants.grant(1, 2);
  for (const std::uint16_t plugin : {std::uint16_t{0}, std::uint16_t{2}}) command(position(0), plugin);
  run();
  for (int i = 0; i < 3; ++i) {
    command(position(0), 2);
    run();
  }
  const auto events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].plugin, 0);
  EXPECT_EQ(frame().joints[1].control, static_cast<std::uint8_t>(Control::kCommanded));
}

TEST_F(FallsTest, silent_hardware_and_a_start_while_it_is_silent_are_told) {
  commanding();
  hardware.status = Status::kTimeout;
  for (int i = 0; i < 3; ++i) {
    command(position(0));
    run();
  }
  auto events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, FallCause::kHardware);
  grantAll();
  run();
  events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, FallCause::kHardware);
  EXPECT_EQ(events[0].grant, 2U);
}

struct FollowingTest : FallsTest {
  FollowingTest() {
    settings.following_errors = {0.3, std::numeric_limits<double>::infinity(), 0.3};
    settings.following_cycles = 20;
    cycle.emplace(robot, settings, hardware, *board, inbox, torque, *state);
    commanding();
  }
  // The robot does not move: it stands where it was put.
  void goOn(int cycles, const link::JointCommand& to) {
    for (int i = 0; i < cycles; ++i) {
      command(to);
      run();
    }
  }
};

TEST_F(FollowingTest, a_joint_that_stays_behind_falls_and_stays_where_it_is) {
  goOn(320, position(1));  // at the limit of its velocity
  const auto events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, FallCause::kFollowing);
  EXPECT_EQ(events[0].joint, 0);
  EXPECT_GT(events[0].error, 0.3);
  EXPECT_EQ(control(), Control::kSafe);
  EXPECT_EQ(hardware.sent[0].position, 0);
}

TEST_F(FollowingTest, a_push_that_is_short_is_none) {
  hardware.position = 0.5;
  goOn(19, position(0));
  hardware.position = 0;
  goOn(1, position(0));
  hardware.position = 0.5;
  goOn(19, position(0));
  EXPECT_TRUE(told().empty());
}

TEST_F(FollowingTest, a_joint_that_is_to_give_way_is_not_supervised) {
  link::JointCommand soft = position(0);
  soft.mode |= link::kStiffness;
  soft.stiffness = 10;
  goOn(1, soft);
  hardware.position = 0.5;
  goOn(100, soft);
  EXPECT_TRUE(told().empty());
}

TEST_F(FollowingTest, a_free_joint_that_is_pushed_is_nobodys) {
  for (std::uint32_t j = 0; j < kJoints; ++j) grants.release(j);
  hardware.position = 0.5;
  goOn(100, position(0));
  EXPECT_TRUE(told().empty());
}

TEST_F(FollowingTest, nothing_of_it_allocates) {
  told();
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    goOn(320, position(1));
  }
  EXPECT_EQ(link::allocationCount().calls, before);
  EXPECT_EQ(told().size(), 1U);
}

}  // namespace
}  // namespace robotui::rt::hal
