#include "robotui/rt/supervisor/ros_process.h"

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {
namespace {

TEST(RosProcess, StartsNothingWhereRosIsNotTheMaster) {
  const RosProcess process(false);
  EXPECT_FALSE(process.isWanted());
  EXPECT_FALSE(process.isDue(link::kSecond));
  EXPECT_EQ(process.lack(), "");
}

TEST(RosProcess, RestsAfterManyDeathsAndThenTriesAgain) {
  RosProcess process(true);
  std::int64_t now = link::kSecond;
  ASSERT_TRUE(process.isDue(now));
  for (int i = 0; i < RespawnPolicy::kMostDeaths - 1; ++i) EXPECT_EQ(process.ended(now += link::kMillisecond), "");
  EXPECT_NE(process.ended(now += link::kMillisecond), "");
  EXPECT_FALSE(process.isDue(now + link::kSecond));
  EXPECT_TRUE(process.isDue(now + 31 * link::kSecond));
}

}  // namespace
}  // namespace robotui::rt::supervisor
