#include "robotui/rt/supervisor/respawn.h"

#include <gtest/gtest.h>

namespace robotui::rt::supervisor {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(RespawnPolicy, StartsAtOnceAfterOneDeathAndLaterEachTime) {
  RespawnPolicy policy;
  policy.ended(1000 * kMs);
  EXPECT_EQ(policy.startAt(), 1000 * kMs);
  policy.ended(1010 * kMs);
  EXPECT_EQ(policy.startAt(), 1110 * kMs);
  policy.ended(1200 * kMs);
  EXPECT_EQ(policy.startAt(), 1400 * kMs);
  EXPECT_FALSE(policy.isGivenUp());
}

TEST(RespawnPolicy, GivesUpAfterFiveDeathsInTenSeconds) {
  RespawnPolicy policy;
  for (int i = 0; i < 5; ++i) {
    policy.ended(i * 1000 * kMs);
  }
  EXPECT_TRUE(policy.isGivenUp());
  policy.reset();
  EXPECT_FALSE(policy.isGivenUp());
}

TEST(RespawnPolicy, ForgetsDeathsOfLongAgo) {
  RespawnPolicy policy;
  for (int i = 0; i < 20; ++i) {
    policy.ended(i * 11000 * kMs);
    EXPECT_EQ(policy.startAt(), i * 11000 * kMs);
  }
  EXPECT_FALSE(policy.isGivenUp());
}

}  // namespace
}  // namespace robotui::rt::supervisor
