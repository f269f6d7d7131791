#include "robotui/rt/link/joint_event.h"

#include <limits>

#include <gtest/gtest.h>

namespace robotui::rt::link {
namespace {

JointEvent event() {
  JointEvent event;
  event.cause = FallCause::kFollowing;
  event.objection = Objection::kBadGain;
  event.plugin = 3;
  event.joint = 127;
  event.grant = 4'000'000'000U;
  event.rejected = 17;
  event.cycle = 1'000'000'000'000ULL;
  event.error = 1.85;
  event.stops = {5, 0x8000};
  event.joints.set(0).set(127);
  return event;
}

std::string_view rest(const std::string& text) { return std::string_view(text).substr(text.find(' ') + 1); }

TEST(JointEvent, comes_out_of_its_text_as_it_went_in) {
  const std::string text = textOf(event());
  EXPECT_EQ(text.substr(0, 7), "joints ");
  const auto read = jointEventOf(rest(text));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->cause, FallCause::kFollowing);
  EXPECT_EQ(read->objection, Objection::kBadGain);
  EXPECT_EQ(read->plugin, 3);
  EXPECT_EQ(read->joint, 127);
  EXPECT_EQ(read->grant, 4'000'000'000U);
  EXPECT_EQ(read->rejected, 17U);
  EXPECT_EQ(read->cycle, 1'000'000'000'000ULL);
  EXPECT_EQ(read->error, 1.85);
  EXPECT_EQ(read->stops, event().stops);
  EXPECT_EQ(read->joints, event().joints);
}

TEST(JointEvent, is_none_where_a_word_is_missing_or_leads_out_of_the_layout) {
  const std::string text = textOf(event());
  EXPECT_FALSE(jointEventOf(""));
  EXPECT_FALSE(jointEventOf("one two"));
  EXPECT_FALSE(jointEventOf(rest(text).substr(0, rest(text).rfind(' '))));
  JointEvent other = event();
  other.plugin = kMaxPlugins;
  EXPECT_FALSE(jointEventOf(rest(textOf(other))));
  other = event();
  other.joint = kMaxJoints;
  EXPECT_FALSE(jointEventOf(rest(textOf(other))));
  other = event();
  other.error = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(jointEventOf(rest(textOf(other))));
  EXPECT_FALSE(jointEventOf("9 0 1 1 1 1 1 1 0 0 0"));
}

}  // namespace
}  // namespace robotui::rt::link
