#include "robotui/rt/link/histogram.h"

#include <gtest/gtest.h>

namespace robotui::rt::link {
namespace {

TEST(Histogram, buckets_follow_each_other_without_a_gap) {
  for (std::size_t i = 1; i < kBuckets; ++i) {
    EXPECT_LT(bucketLower(i - 1), bucketLower(i));
    EXPECT_EQ(bucketOf(bucketLower(i)), i);
    EXPECT_EQ(bucketOf(bucketLower(i) - 1), i - 1);
  }
}

TEST(Histogram, takes_what_no_duration_can_be) {
  EXPECT_EQ(bucketOf(INT64_MIN), 0U);
  EXPECT_EQ(bucketOf(0), 0U);
  EXPECT_EQ(bucketOf(INT64_MAX), kBuckets - 1);
}

TEST(Histogram, percentile_is_at_most_a_quarter_above_the_value) {
  Histogram histogram{};
  for (std::int64_t i = 1; i <= 1000; ++i) record(histogram, i * 1000);
  for (const double fraction : {0.01, 0.5, 0.9, 0.99, 0.999}) {
    const double value = fraction * 1'000'000;
    EXPECT_GE(static_cast<double>(percentile(histogram, fraction)), value);
    EXPECT_LE(static_cast<double>(percentile(histogram, fraction)), value * 1.25);
  }
  EXPECT_EQ(percentile(histogram, 1), 1'000'000);
  EXPECT_EQ(histogram.count, 1000U);
}

TEST(Histogram, of_nothing_is_zero_and_of_one_is_that_one) {
  Histogram histogram{};
  EXPECT_EQ(percentile(histogram, 0.99), 0);
  record(histogram, 12345);
  EXPECT_EQ(percentile(histogram, 0), 12345);
  EXPECT_EQ(percentile(histogram, 0.99), 12345);
}

TEST(Histogram, difference_counts_what_came_in_between) {
  Histogram early{};
  record(early, 100);
  Histogram late = early;
  record(late, 5000);
  record(late, 5000);
  const Histogram between = difference(late, early);
  EXPECT_EQ(between.count, 2U);
  EXPECT_EQ(between.buckets[bucketOf(5000)], 2U);
  EXPECT_EQ(between.buckets[bucketOf(100)], 0U);
}

}  // namespace
}  // namespace robotui::rt::link
