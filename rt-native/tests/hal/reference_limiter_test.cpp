// What hardware is told, cycle by cycle, never changes faster than the joint may: whatever a plugin wants.
#include "reference_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "rig.h"
#include "robotui/rt/link/allocations.h"

namespace robotui::rt::hal {
namespace {

constexpr double kPeriod = 0.001;
constexpr double kRounding = 1e-6;  // of the differences of references, as a fraction

config::JointDescription jointOf(double acceleration, double jerk) {
  return {1, "joint", config::JointType::kRevolute, -2, 2, 2, 50, acceleration, jerk};
}

// The greatest differences of a series of positions.
class Watch {
 public:
  void take(double position) {
    const double v = (position - position_) / kPeriod;
    const double a = (v - velocity_) / kPeriod;
    most_velocity = std::max(most_velocity, std::abs(v));
    most_acceleration = std::max(most_acceleration, std::abs(a));
    most_jerk = std::max(most_jerk, std::abs(a - acceleration_) / kPeriod);
    highest = std::max(highest, position);
    lowest = std::min(lowest, position);
    position_ = position;
    velocity_ = v;
    acceleration_ = a;
  }
  void expectWithin(const config::JointDescription& joint) const {
    EXPECT_LE(most_velocity, joint.velocity * (1 + kRounding));
    EXPECT_LE(most_acceleration, joint.acceleration * (1 + kRounding));
    EXPECT_LE(most_jerk, joint.jerk * (1 + kRounding));
    EXPECT_LE(highest, joint.upper + kRounding);
    EXPECT_GE(lowest, joint.lower - kRounding);
  }

  double most_velocity = 0;
  double most_acceleration = 0;
  double most_jerk = 0;
  double highest = 0;
  double lowest = 0;

 private:
  double position_ = 0;
  double velocity_ = 0;
  double acceleration_ = 0;
};

struct Ran {
  Watch watch;
  double end = 0;
  double farthest = 0;  // from what was wanted
};

// From zero, for so many cycles.
Ran follow(const config::JointDescription& joint, int cycles, const std::function<double(int)>& wanted, int every = 1) {
  ReferenceLimiter limiter(joint, kPeriod);
  limiter.reset(0);
  Ran ran;
  for (int i = 1; i <= cycles; ++i) {
    ran.end = limiter.follow(wanted(i - i % every), i % every == 0);
    ran.watch.take(ran.end);
    ran.farthest = std::max(ran.farthest, std::abs(ran.end - wanted(i)));
  }
  return ran;
}

TEST(ReferenceLimiter, a_step_ends_exactly_there_in_nearly_the_least_time) {
  const auto joint = jointOf(20, 400);
  const auto early = follow(joint, 640, [](int) { return 1.0; });
  const auto late = follow(joint, 660, [](int) { return 1.0; });  // 1 / 2 + 2 / 20 + 20 / 400 = 0.65 s is the least
  EXPECT_LT(early.end, 1);
  EXPECT_EQ(late.end, 1);
  EXPECT_EQ(late.watch.highest, 1) << "it does not go beyond";
  EXPECT_GT(late.watch.most_velocity, 1.99);
  late.watch.expectWithin(joint);
}

TEST(ReferenceLimiter, a_reference_that_flips_by_a_radian_every_two_milliseconds_moves_within_the_limits) {
  const auto joint = jointOf(20, 400);
  const auto ran = follow(joint, 20'000, [](int i) { return i / 2 % 2 == 0 ? 0.0 : 1.0; });
  ran.watch.expectWithin(joint);
  EXPECT_GT(ran.watch.highest, 0) << "it moves";
}

TEST(ReferenceLimiter, ends_exactly_at_both_ends_of_the_range) {
  const auto joint = jointOf(20, 400);
  for (const double end : {joint.upper, joint.lower}) {
    const Ran leap = follow(joint, 2000, [&](int) { return end; });
    EXPECT_EQ(leap.end, end);
    leap.watch.expectWithin(joint);
    const Ran slow = follow(joint, 4000, [&](int i) { return std::min(1.0, i * kPeriod / 2) * end; });
    EXPECT_EQ(slow.end, end);
    slow.watch.expectWithin(joint);
    const Ran fast = follow(joint, 3000, [&](int i) { return std::min(1.0, i * kPeriod * 2 / 2) * end; });
    EXPECT_EQ(fast.end, end);
    fast.watch.expectWithin(joint);
  }
}

TEST(ReferenceLimiter, what_is_within_the_limits_goes_through_as_it_is) {
  const auto sine = [](int i) { return 0.1 * std::pow(1 - std::cos(2 * kPeriod * i), 2); };
  const auto joint = jointOf(20, 400);
  const auto ran = follow(joint, 8000, sine);
  EXPECT_EQ(ran.farthest, 0);
}

TEST(ReferenceLimiter, a_plugin_that_speaks_every_fourth_cycle_is_followed_evenly) {
  const auto sine = [](int i) { return 0.3 * (1 - std::cos(2 * kPeriod * i)); };
  const auto joint = jointOf(20, 400);
  const auto ran = follow(joint, 8000, sine, 4);
  ran.watch.expectWithin(joint);
  EXPECT_LT(ran.farthest, 0.01) << "0.6 rad/s for four cycles, and what it takes to begin";
  EXPECT_LT(ran.watch.most_velocity, 0.7) << "a staircase would be followed in leaps";
}

TEST(ReferenceLimiter, nothing_that_is_wanted_goes_beyond_any_limit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-3, 3);
  for (const double jerk : {50.0, 400.0, 40'000.0}) {
    for (const double acceleration : {2.0, 20.0, 200.0}) {
      const auto joint = jointOf(acceleration, jerk);
      double goal = 0;
      const auto ran =
          follow(joint, 20'000, [&](int i) { return i % 97 == 0 || i % 350 > 300 ? goal = anywhere(random) : goal; });
      SCOPED_TRACE("acceleration " + std::to_string(acceleration) + ", jerk " + std::to_string(jerk));
      ran.watch.expectWithin(joint);
      const auto still = follow(joint, 20'000, [&](int i) { return i < 300 ? 1.9 : -0.5; });
      EXPECT_EQ(still.end, -0.5);
      EXPECT_EQ(still.watch.lowest, -0.5);
    }
  }
}

TEST(ReferenceLimiter, asks_nothing_of_the_heap) {
  ReferenceLimiter limiter(jointOf(20, 400), kPeriod);
  limiter.reset(0);
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    for (int i = 0; i < 100; ++i) {
      limiter.follow(i % 3, true);
      limiter.brake();
      limiter.followVelocity(i % 5);
    }
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

TEST(ReferenceLimiter, one_limit_alone_is_kept_too) {
  const double none = std::numeric_limits<double>::infinity();
  const auto by_acceleration = follow(jointOf(20, none), 2000, [](int) { return 1.0; });
  EXPECT_LE(by_acceleration.watch.most_acceleration, 20 * (1 + kRounding));
  EXPECT_EQ(by_acceleration.end, 1);
  const auto by_jerk = follow(jointOf(none, 400), 2000, [](int) { return 1.0; });
  EXPECT_LE(by_jerk.watch.most_jerk, 400 * (1 + kRounding));
  EXPECT_EQ(by_jerk.end, 1);
  EXPECT_FALSE(ReferenceLimiter(jointOf(none, none), kPeriod).isActive());
}

TEST(ReferenceLimiter, velocities_that_lead_are_limited_likewise) {
  const auto joint = jointOf(20, 400);
  ReferenceLimiter limiter(joint, kPeriod);
  limiter.reset(0);
  double position = 0;
  Watch watch;
  for (int i = 0; i < 3000; ++i)
    watch.take(position += limiter.followVelocity(i < 300 ? 5 : i < 320 ? -5 : 1) * kPeriod);
  EXPECT_LE(watch.most_velocity, 2 * (1 + kRounding));
  EXPECT_LE(watch.most_acceleration, 20 * (1 + kRounding));
  EXPECT_LE(watch.most_jerk, 400 * (1 + kRounding));
  EXPECT_EQ(limiter.velocity(), 1);
}

// ---- in a whole cycle of the HAL ----

struct LimitedRig : testing::Test, Rig {
  LimitedRig() {
    for (auto& joint : robot.joints) {
      joint.velocity = 2;
      joint.acceleration = 20;
      joint.jerk = 400;
    }
    cycle.emplace(robot, settings, hardware, *board, inbox, torque, *state);
    run();
    grantAll();
  }
  void step(double wanted) {
    command(position(wanted));
    run();
    watch.take(hardware.sent[0].position);
    hardware.position = hardware.sent[0].position;
  }
  void expectWithin() const { watch.expectWithin(robot.joints[0]); }
  Watch watch;
};

TEST_F(LimitedRig, flips_reach_the_hardware_within_the_limits) {
  for (int i = 0; i < 5000; ++i) step(i / 2 % 2 == 0 ? 0 : 1);
  expectWithin();
  EXPECT_GT(frame().joints[0].clamped, 0U);
}

TEST_F(LimitedRig, what_a_slow_plugin_says_within_the_limits_is_not_cut) {
  run();
  grantAll(1);
  while (number % 10 != 9) run();
  for (int i = 0; i < 300; ++i) {
    answer(number + 1, position(0.5 - 0.5 * std::cos(0.01 * i)), 1);
    for (int k = 0; k < 10; ++k) run();
  }
  EXPECT_GT(hardware.sent[0].position, 0.9);
  EXPECT_EQ(frame().joints[0].clamped, 0U);
}

TEST_F(LimitedRig, a_plugin_that_goes_silent_leaves_a_joint_that_brakes_within_the_limits) {
  for (int i = 0; i < 300; ++i) step(1.5);
  EXPECT_GT(watch.most_velocity, 1.9);
  for (int i = 0; i < 400; ++i) {
    run();
    watch.take(hardware.sent[0].position);
  }
  expectWithin();
  const double stopped = hardware.sent[0].position;
  run();
  EXPECT_EQ(hardware.sent[0].position, stopped);
  EXPECT_LT(stopped, 1.5);
}

TEST_F(LimitedRig, one_answer_that_is_missing_is_no_stop) {
  for (int i = 0; i < 300; ++i) step(1.5);
  const double before = hardware.sent[0].position;
  run();
  EXPECT_GT(hardware.sent[0].position - before, 1.9 * kPeriod);
  watch.take(hardware.sent[0].position);
  for (int i = 0; i < 1000; ++i) step(1.5);
  EXPECT_EQ(hardware.sent[0].position, 1.5);
  expectWithin();
}

TEST_F(LimitedRig, the_end_waits_until_all_have_braked) {
  for (int i = 0; i < 300; ++i) step(1.5);
  cycle->end();
  run();
  EXPECT_FALSE(cycle->isAtRest());
  for (int i = 0; i < 400; ++i) run();
  EXPECT_TRUE(cycle->isAtRest());
}

}  // namespace
}  // namespace robotui::rt::hal
