// When an answer counts: link/PROTOCOL.md. The clock is the test's own, so nothing here depends on the machine.
#include <gtest/gtest.h>

#include "rig.h"

namespace robotui::rt::hal {
namespace {

using link::Control;

constexpr std::int64_t kLate = 900 * link::kMicrosecond;    // behind the deadline, before the next cycle
constexpr std::int64_t kInTime = 700 * link::kMicrosecond;  // before the deadline

struct AnswersTest : testing::Test, Rig {
  void SetUp() override {
    hardware.position = 0.5;
    run();
    grantAll();
  }

  // The cycle that comes is answered that long after its start.
  void answerAfter(std::int64_t ns, double where, std::uint16_t plugin = 0) {
    time.at(time.now + ns, [this, to = number + 1, where, plugin] { answer(to, position(where), plugin); });
  }

  void runAnswered(std::int64_t ns, double where, std::uint16_t plugin = 0) {
    answerAfter(ns, where, plugin);
    run();
  }

  Control controlNow() const { return static_cast<Control>(frame().joints[0].control); }  // as the cycle before left it
  std::uint64_t missed() { return cycle->statistics().missed_commands; }
  double sent() const { return hardware.sent[0].position; }
};

TEST_F(AnswersTest, one_that_comes_before_the_deadline_counts_in_its_cycle) {
  runAnswered(kInTime, 0.5005);
  EXPECT_DOUBLE_EQ(sent(), 0.5005);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(AnswersTest, one_that_comes_late_is_a_miss_and_is_obeyed_in_the_next_cycle) {
  runAnswered(kInTime, 0.5);
  runAnswered(kLate, 0.5005);
  EXPECT_DOUBLE_EQ(sent(), 0.5);
  EXPECT_EQ(missed(), 1U);
  run();
  EXPECT_DOUBLE_EQ(sent(), 0.5005);
  EXPECT_EQ(missed(), 2U);
}

TEST_F(AnswersTest, a_thread_that_is_always_one_cycle_late_is_obeyed_one_cycle_late_and_counted) {
  runAnswered(kInTime, 0.5);
  double where = 0.5;
  for (int i = 0; i < 200; ++i) {
    const double last = where;
    where += 0.0005;
    runAnswered(kLate, where);
    EXPECT_DOUBLE_EQ(sent(), last) << i;
    EXPECT_TRUE(i < 2 || controlNow() == Control::kCommanded) << i;
  }
  EXPECT_EQ(missed(), 200U);
}

TEST_F(AnswersTest, a_late_thread_that_catches_up_is_in_time_again) {
  runAnswered(kInTime, 0.5);
  for (int i = 0; i < 5; ++i) runAnswered(kLate, 0.5);
  const std::uint64_t before = missed();
  for (int i = 0; i < 5; ++i) runAnswered(kInTime, 0.5);
  EXPECT_EQ(missed(), before);
  EXPECT_EQ(controlNow(), Control::kCommanded);
}

TEST_F(AnswersTest, who_falls_silent_after_a_late_answer_is_safe_as_soon_as_any_other) {
  runAnswered(kInTime, 0.5);
  runAnswered(kLate, 0.5);  // misses
  run();                    // obeys it, late by one
  run();                    // silent: the second miss in turn
  EXPECT_EQ(controlNow(), Control::kCommanded);
  run();
  EXPECT_EQ(controlNow(), Control::kSafe);
}

TEST_F(AnswersTest, one_that_is_older_than_the_misses_allowed_is_not_obeyed) {
  runAnswered(kInTime, 0.5);
  run();
  time.at(time.now, [this, to = number] { answer(to - 1, position(0.6)); });  // older than the last one: none
  time.at(time.now, [this, to = number] { answer(to, position(0.6)); });
  run();
  EXPECT_NE(sent(), 0.5) << "one cycle late";
  run();
  run();
  EXPECT_EQ(controlNow(), Control::kSafe);
  const double there = sent();
  answer(number - 1, position(0.6));
  run();
  EXPECT_EQ(sent(), there);
}

TEST_F(AnswersTest, where_one_miss_is_allowed_no_answer_may_be_late) {
  CommandInbox strict(CommandPlan{{{0, 0, 1}}, {0}, kStartCycles}, kJoints, 1, time);
  strict.offer(0, CommandInbox::HostView::open(host.shareReadOnly()));
  answer(10, position(0.5));
  const auto collected = [&](std::uint64_t at) {
    strict.begin();
    strict.want(0);
    strict.collect(at, 0);
    return strict.answer(0);
  };
  EXPECT_EQ(collected(10), Answer::kFresh);
  answer(11, position(0.5));
  EXPECT_EQ(collected(12), Answer::kSafe);
}

TEST_F(AnswersTest, a_plugin_that_was_just_granted_its_joints_has_time_to_start) {
  for (std::uint64_t i = 0; i + 2 < kStartCycles; ++i) run();
  EXPECT_EQ(controlNow(), Control::kHolding);
  EXPECT_EQ(missed(), 0U);
  runAnswered(kInTime, 0.5005);
  EXPECT_DOUBLE_EQ(sent(), 0.5005);
  run();
  run();
  run();
  EXPECT_EQ(controlNow(), Control::kSafe) << "from its first answer on the misses count";
}

TEST_F(AnswersTest, a_plugin_that_never_starts_is_made_safe) {
  for (std::uint64_t i = 0; i < kStartCycles + 3; ++i) run();
  EXPECT_EQ(controlNow(), Control::kSafe);
}

TEST_F(AnswersTest, a_grant_to_another_plugin_of_the_thread_forgives_its_misses_only_where_it_had_failed) {
  for (std::uint32_t j = 0; j < 2; ++j) runAnswered(kInTime, 0.5);
  run();
  grants.grant(1, 0);  // a joint more for who has just missed
  run();
  run();
  EXPECT_EQ(controlNow(), Control::kSafe);
}

TEST_F(AnswersTest, a_slower_thread_that_is_late_goes_on_with_the_answer_that_came) {
  while (number < 9) run();
  grantAll(1);
  runAnswered(kInTime, 0.5, 1);
  for (std::uint64_t due = 20; due < 70; due += 10) {
    while (number < due + 10) run();  // the next period has begun: a miss
    EXPECT_EQ(controlNow(), Control::kCommanded);
    answer(due, position(0.5), 1);
    run();
    EXPECT_EQ(controlNow(), Control::kHolding);
  }
  EXPECT_EQ(missed(), 5U);
}

// What becomes of one host is nothing to the other, whatever time it is.
TEST_F(AnswersTest, a_host_that_dies_makes_its_joints_safe_within_two_cycles_and_leaves_those_of_others) {
  grants.grant(2, 2);
  const auto runBoth = [&](bool first_lives) {
    if (first_lives) answerAfter(kInTime, 0.5);
    answerAfter(kInTime, 0.5, 2);
    run();
  };
  for (int i = 0; i < 10; ++i) runBoth(true);
  runBoth(false);
  EXPECT_EQ(controlNow(), Control::kCommanded);  // the last one
  runBoth(false);
  EXPECT_EQ(controlNow(), Control::kHolding);
  for (int i = 0; i < 10; ++i) {
    runBoth(false);
    EXPECT_EQ(controlNow(), Control::kSafe);
    EXPECT_EQ(frame().joints[2].control, static_cast<std::uint8_t>(Control::kCommanded));
  }
  EXPECT_EQ(missed(), 2U);
}

}  // namespace
}  // namespace robotui::rt::hal
