#include "stamp_gate.h"

#include <gtest/gtest.h>

#include "../notices.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::gazebo {
namespace {

constexpr std::int64_t kMs = link::kMillisecond;

TEST(StampGate, takes_what_is_newer_and_drops_what_is_late) {
  StampGate gate(100 * kMs);
  EXPECT_EQ(gate.admit(0, 0), Stamp::kNew);
  EXPECT_EQ(gate.admit(5, kMs), Stamp::kNew);
  EXPECT_EQ(gate.admit(3, 2 * kMs), Stamp::kLate);
  EXPECT_EQ(gate.admit(5, 3 * kMs), Stamp::kSame);
  EXPECT_EQ(gate.admit(6, 4 * kMs), Stamp::kNew);
}

TEST(StampGate, time_that_goes_on_from_the_past_was_reset) {
  StampGate gate(100 * kMs);
  gate.admit(1000, 0);
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(gate.admit(i, i * kMs), Stamp::kLate);
  EXPECT_EQ(gate.admit(5, 5 * kMs), Stamp::kReset);
  EXPECT_EQ(gate.admit(6, 6 * kMs), Stamp::kNew);
}

TEST(StampGate, an_older_sender_beside_the_newer_one_is_no_reset) {
  StampGate gate(100 * kMs);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(gate.admit(1000 + i, i * kMs), Stamp::kNew);
    EXPECT_EQ(gate.admit(1 + i, i * kMs), Stamp::kLate);
  }
}

TEST(StampGate, after_a_silence_any_time_is_taken) {
  StampGate gate(100 * kMs);
  gate.admit(1000, 0);
  EXPECT_EQ(gate.admit(7, 101 * kMs), Stamp::kReset);
}

TEST(GazeboNotices, tell_a_condition_once_and_when_it_is_over) {
  Notices notices;
  notices.raise("a", "begins", link::kSecond);
  notices.raise("a", "begins", 30 * link::kSecond);
  EXPECT_EQ(notices.take(), std::vector<std::string>{"begins"});
  notices.clear("a", "ends");
  notices.clear("a", "ends");
  EXPECT_EQ(notices.take(), std::vector<std::string>{"ends"});
}

TEST(GazeboNotices, bound_what_comes_and_goes) {
  Notices notices;
  for (int i = 0; i < 1000; ++i) {
    notices.raise("a", "begins", link::kSecond + i);
    notices.clear("a", "ends");
    notices.tell("b", "happened", link::kSecond + i);
  }
  EXPECT_EQ(notices.take(), (std::vector<std::string>{"begins", "ends", "happened"}));
  for (int i = 0; i < 1000; ++i) notices.tell("c" + std::to_string(i), "much", link::kSecond);
  EXPECT_LE(notices.take().size(), 32U);
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
