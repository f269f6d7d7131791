#include "cycle.h"

#include <cmath>
#include <limits>
#include <cstring>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "rig.h"
#include "robotui/rt/link/futex.h"

namespace robotui::rt::hal {
namespace {

using link::Control;

struct CycleTest : testing::Test, Rig {
  // The plugin owns all joints and commanded last in this cycle.
  void commanding(const link::JointCommand& first) {
    hardware.position = 0.5;
    run();
    grantAll();
    command(first);
    run();
  }

  // Of plugin 1, which answers every tenth cycle.
  void answerTen(double wanted) {
    while (number % 10 != 9) run();
    answer(number + 1, position(wanted), 1);
    run();
  }
};

TEST_F(CycleTest, a_free_joint_holds_where_it_was_found) {
  hardware.position = 0.5;
  run();
  hardware.position = 0.6;  // pushed
  EXPECT_EQ(control(), Control::kFree);
  EXPECT_EQ(hardware.sent[0].position, 0.5);
  EXPECT_EQ(hardware.sent[0].mode, link::kPosition);
}

TEST_F(CycleTest, frames_have_every_number_once) {
  link::StateReader reader(*state);
  link::FrameData data{};
  for (std::uint64_t i = 1; i <= 50; ++i) {
    run();
    ASSERT_EQ(reader.next(data), link::Read::kNew);
    EXPECT_EQ(data.cycle, i);
  }
  EXPECT_EQ(reader.lost(), 0U);
}

TEST_F(CycleTest, a_command_moves_from_the_measured_position_at_the_velocity_limit) {
  commanding(position(1));
  EXPECT_DOUBLE_EQ(hardware.sent[0].position, 0.501);
  command(position(1));
  run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].position, 0.502);
  EXPECT_EQ(frame().joints[0].clamped, 1U);
}

TEST_F(CycleTest, a_slow_plugin_within_the_velocity_limit_is_not_cut) {
  run();
  grantAll(1);
  for (int i = 0; i < 30; ++i) answerTen(0.005 * i);
  EXPECT_EQ(frame().joints[0].clamped, 0U);
  for (int i = 0; i < 20; ++i) answerTen(0.15 + 0.015 * i);
  const std::uint32_t cut = frame().joints[0].clamped;
  EXPECT_GT(cut, 10U);
  EXPECT_LT(cut, 30U) << "once a command, not in each of its cycles";
}

TEST_F(CycleTest, commands_of_another_than_the_owner_move_nothing) {
  hardware.position = 0.5;
  run();
  grants.grant(0, 0);
  link::JointCommand foreign = position(1);
  command(foreign);
  run();
  EXPECT_NE(hardware.sent[0].position, 0.5);
  EXPECT_EQ(hardware.sent[1].position, 0.5);
  // In the owner's own slot, but in the name of another plugin.
  link::CommandData data{};
  data.cycle = number + 1;
  data.joints.fill(position(1));
  data.joints[0].plugin = 5;
  const double before = hardware.sent[0].position;
  link::SlotWriter(*host, 0, kJoints).write(data);
  run();
  EXPECT_EQ(hardware.sent[0].position, before);
  run();
  EXPECT_EQ(frame().joints[0].rejected, 1U);
}

TEST_F(CycleTest, is_safe_in_exactly_as_many_cycles_as_configured_after_a_thread_falls_silent) {
  commanding(position(0.5));
  EXPECT_EQ(control(), Control::kCommanded);  // as the cycle before left it; this one misses
  EXPECT_EQ(control(), Control::kHolding);
  EXPECT_EQ(control(), Control::kSafe);
  EXPECT_EQ(cycle->statistics().missed_commands, 2U);
}

TEST_F(CycleTest, one_miss_is_forgotten_with_the_next_command) {
  commanding(position(0.5));
  for (int i = 0; i < 10; ++i) {
    run();
    command(position(0.5));
    run();
  }
  EXPECT_EQ(control(), Control::kCommanded);
  EXPECT_EQ(cycle->statistics().missed_commands, 11U);
}

TEST_F(CycleTest, safe_state_ends_with_a_new_grant_only) {
  commanding(position(1));
  run();
  run();
  hardware.position = 0.9;
  command(position(1));
  EXPECT_EQ(control(), Control::kSafe);
  grantAll();
  command(position(1));
  run();
  EXPECT_EQ(control(), Control::kCommanded);
  EXPECT_NEAR(hardware.sent[0].position, 0.9, 0.0011);  // from where it was measured
}

TEST_F(CycleTest, a_velocity_goes_to_zero_at_its_limit_of_change) {
  commanding(velocity(0.005));
  for (int i = 0; i < 4; ++i) {
    command(velocity(0.035));
    run();
  }
  EXPECT_DOUBLE_EQ(hardware.sent[0].velocity, 0.035);
  run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].velocity, 0.025);
  for (int i = 0; i < 3; ++i) run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].velocity, 0);
}

TEST_F(CycleTest, an_effort_follows_the_safe_law_with_damping_within_its_limit) {
  commanding(effort(20));
  EXPECT_EQ(hardware.sent[0].effort, 20);
  hardware.velocity = 0.5;
  run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].effort, 7 - 2 * 0.5);
  torque.value = std::numeric_limits<double>::quiet_NaN();
  run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].effort, -2 * 0.5);
  torque.value = 1e9;
  run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].effort, 50);
}

TEST_F(CycleTest, a_joint_that_is_released_holds_in_its_mode) {
  commanding(position(0.5005));
  grants.release(0);
  for (int i = 0; i < 5; ++i) run();
  EXPECT_EQ(control(), Control::kFree);
  EXPECT_DOUBLE_EQ(hardware.sent[0].position, 0.5005);
}

TEST_F(CycleTest, a_slower_thread_has_its_own_period_and_misses_in_it) {
  hardware.position = 0.5;
  while (number < 9) run();
  grantAll(1);
  command(position(0.5), 1);  // answers cycle 10
  for (int i = 0; i < 10; ++i) run();
  EXPECT_EQ(control(), Control::kCommanded);  // cycle 20: its whole period was silent only after this one
  EXPECT_EQ(cycle->statistics().missed_commands, 0U);
  while (number < 30) run();
  EXPECT_EQ(cycle->statistics().missed_commands, 1U);
  EXPECT_EQ(control(), Control::kHolding);
  while (number < 40) run();
  EXPECT_EQ(control(), Control::kSafe);
}

TEST_F(CycleTest, what_is_no_number_never_reaches_the_hardware_and_is_counted) {
  commanding(position(0.5));
  command(position(std::numeric_limits<double>::quiet_NaN()));
  run();
  EXPECT_DOUBLE_EQ(hardware.sent[0].position, 0.5);
  EXPECT_EQ(control(), Control::kHolding);
  EXPECT_EQ(frame().joints[0].rejected, 1U);
}

TEST_F(CycleTest, measurements_that_are_no_numbers_are_a_fault_and_the_last_ones_stay) {
  hardware.position = 0.25;
  run();
  hardware.position = std::numeric_limits<double>::quiet_NaN();
  run();
  EXPECT_EQ(frame().joints[0].link_position, 0.25);
  EXPECT_EQ(frame().hal_status, static_cast<std::uint32_t>(Status::kFault));
}

TEST_F(CycleTest, before_the_first_measurement_nothing_is_sent) {
  hardware.status = Status::kTimeout;
  run();
  run();
  EXPECT_EQ(hardware.moves, 0);
  hardware.status = Status::kOk;
  run();
  EXPECT_EQ(hardware.moves, 1);
}

TEST_F(CycleTest, a_robot_that_was_away_is_safe_and_holds_where_it_is_found) {
  commanding(position(0.6));
  hardware.status = Status::kTimeout;
  for (int i = 0; i < 3; ++i) {
    command(position(0.6));
    run();
  }
  hardware.status = Status::kOk;
  hardware.position = -1;
  command(position(0.6));
  run();
  EXPECT_EQ(control(), Control::kSafe);
  EXPECT_EQ(hardware.sent[0].position, -1);
  EXPECT_EQ(cycle->statistics().sense_failures, 3U);
}

TEST_F(CycleTest, a_hal_that_comes_back_moves_nothing_that_was_owned) {
  grantAll();
  command(position(1));
  run();
  command(position(1));
  EXPECT_EQ(control(), Control::kSafe);
}

TEST_F(CycleTest, at_the_end_all_is_safe_and_comes_to_rest) {
  commanding(velocity(0.01));
  cycle->end();
  command(velocity(0.01));
  run();
  EXPECT_EQ(control(), Control::kSafe);
  EXPECT_TRUE(cycle->isAtRest());
  EXPECT_EQ(hardware.sent[0].velocity, 0);
}

TEST_F(CycleTest, a_host_that_was_replaced_is_listened_to) {
  commanding(position(0.5));
  host = link::Segment<link::HostSegment>::create(2);
  inbox.offer(0, CommandInbox::HostView::open(host.shareReadOnly()));
  command(position(0.4));
  run();
  EXPECT_LT(hardware.sent[0].position, 0.5);
}

// Whatever a host writes into its memory: what goes to the hardware is a number within the limits, and moves no faster
// than allowed.
TEST_F(CycleTest, random_bytes_in_a_slot_are_harmless) {
  commanding(position(0.5));
  std::mt19937_64 random(42);
  const auto word = [&] { return random(); };
  double last = hardware.sent[0].position;
  for (int i = 0; i < 3000; ++i) {
    link::CommandData data{};
    for (std::size_t w = 0; w < sizeof(data) / 8; ++w) {
      const std::uint64_t bits = word();
      std::memcpy(reinterpret_cast<char*>(&data) + w * 8, &bits, 8);
    }
    data.cycle = i % 3 == 0 ? data.cycle : number + 1;
    for (link::JointCommand& each : data.joints) {
      if (i % 2 == 0) each.plugin = 0;
      if (i % 4 == 0) each.mode &= 31;
    }
    link::SlotWriter(*host, 0, kJoints).write(data);
    if (i % 10 == 0) grantAll();
    run();
    for (const Reference& sent : hardware.sent) {
      ASSERT_TRUE(std::isfinite(sent.position) && std::abs(sent.velocity) <= 1 && std::abs(sent.effort) <= 50);
      ASSERT_TRUE(std::isfinite(sent.stiffness) && std::isfinite(sent.damping) && sent.stiffness >= 0 &&
                  sent.damping >= 0);
    }
    const bool anchored = i % 10 == 0;
    ASSERT_TRUE(anchored || std::abs(hardware.sent[0].position - last) <= 0.001 + 1e-12);
    last = hardware.sent[0].position;
  }
}

TEST_F(CycleTest, random_owners_on_the_board_are_harmless) {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    grants.grant(0, static_cast<std::uint16_t>(random()));
    run();
  }
  EXPECT_TRUE(std::isfinite(hardware.sent[0].position));
}

TEST_F(CycleTest, a_host_that_rings_without_end_costs_the_deadline_and_no_more) {
  commanding(position(0.5));
  const std::int64_t start = time.now;
  std::int64_t end = 0;
  for (int i = 0; i < 1000; ++i) {
    time.at(start + i * 10 * link::kMicrosecond, [&] {
      link::ringBell(host->bell);
      end = std::max(end, hardware.moves == 2 ? time.now : 0);  // the last ring before this cycle moved
    });
  }
  run();
  EXPECT_EQ(hardware.moves, 3);
  EXPECT_LE(end - start, 800 * link::kMicrosecond);
}

// The same with a host that rings for real: how long it takes is not judged, but it ends.
TEST(CycleInTime, a_host_that_rings_without_end_keeps_nobody) {
  Waiting waiting;
  Rig rig(&waiting);
  rig.run();
  rig.grantAll();
  rig.command(position(0.5));
  rig.run();
  std::jthread ringing([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) link::ringBell(rig.host->bell);
  });
  rig.cycle->run(++rig.number, link::now());
  EXPECT_EQ(rig.hardware.moves, 3);
}

}  // namespace
}  // namespace robotui::rt::hal
