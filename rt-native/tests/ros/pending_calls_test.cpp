#include "pending_calls.h"

#include <gtest/gtest.h>

#include <thread>

namespace robotui::rt::ros_bridge {
namespace {

using std::chrono::milliseconds;

TEST(PendingCalls, GoToWhoAsked) {
  PendingCalls answers;
  const auto first = answers.expect();
  const auto second = answers.expect();
  std::thread other([&] {
    answers.settle(second, {false, {2}});
    answers.settle(first, {true, {1}});
  });
  const auto answer = answers.await(first, milliseconds(5000));
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->succeeded);
  EXPECT_EQ(answer->bytes, std::vector<std::uint8_t>{1});
  EXPECT_FALSE(answers.await(second, milliseconds(5000))->succeeded);
  other.join();
}

TEST(PendingCalls, ThatComeTooLateAreNothing) {
  PendingCalls answers;
  const auto number = answers.expect();
  EXPECT_FALSE(answers.await(number, milliseconds(1)));
  answers.settle(number, {true, {}});
  EXPECT_FALSE(answers.await(answers.expect(), milliseconds(1)));
}

}  // namespace
}  // namespace robotui::rt::ros_bridge
