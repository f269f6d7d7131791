#include "robotui/rt/supervisor/ros_keeper.h"

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {
namespace {

TEST(RosKeeper, StartsNothingWhereRosIsNotTheMaster) {
  const RosKeeper keeper(false);
  EXPECT_FALSE(keeper.isWanted());
  EXPECT_FALSE(keeper.isDue(link::kSecond));
  EXPECT_EQ(keeper.lack(), "");
}

TEST(RosKeeper, RestsAfterManyDeathsAndThenTriesAgain) {
  RosKeeper keeper(true);
  std::int64_t now = link::kSecond;
  ASSERT_TRUE(keeper.isDue(now));
  for (int i = 0; i < RespawnPolicy::kMostDeaths - 1; ++i) EXPECT_EQ(keeper.died(now += link::kMillisecond), "");
  EXPECT_NE(keeper.died(now += link::kMillisecond), "");
  EXPECT_FALSE(keeper.isDue(now + link::kSecond));
  EXPECT_TRUE(keeper.isDue(now + 31 * link::kSecond));
}

}  // namespace
}  // namespace robotui::rt::supervisor
