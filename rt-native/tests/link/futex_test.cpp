#include "robotui/rt/link/futex.h"

#include <thread>

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/segment.h"

namespace robotui::rt::link {
namespace {

TEST(Futex, a_bell_that_rose_before_is_not_waited_for) {
  std::atomic<std::uint32_t> bell{2};
  EXPECT_TRUE(waitForBell(bell, 1, now() + 10 * kSecond));
}

TEST(Futex, on_a_read_only_map_the_deadline_ends_the_sleep) {
  const auto state = Segment<StateSegment>::create(1);
  const auto reader = Segment<const StateSegment>::open(state.shareReadOnly());
  const std::int64_t begin = now();
  EXPECT_FALSE(waitForBell(reader->bell, 0, begin + 10 * kMillisecond));
  EXPECT_GE(now() - begin, 10 * kMillisecond);
}

TEST(Futex, a_deadline_in_the_past_or_before_all_time_returns_at_once) {
  std::atomic<std::uint32_t> bell{0};
  EXPECT_FALSE(waitForBell(bell, 0, now() - kSecond));
  EXPECT_FALSE(waitForBell(bell, 0, -1));
}

}  // namespace
}  // namespace robotui::rt::link
