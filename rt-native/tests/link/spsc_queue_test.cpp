#include "robotui/rt/link/spsc_queue.h"

#include <gtest/gtest.h>

#include <thread>

namespace robotui::rt::link {
namespace {

TEST(SpscQueue, GivesWhatWasPutInUntilItIsFull) {
  SpscQueue<int, 2> queue;
  int got = 0;
  EXPECT_FALSE(queue.pop(got));
  EXPECT_TRUE(queue.push(1));
  EXPECT_TRUE(queue.push(2));
  EXPECT_FALSE(queue.push(3));
  EXPECT_TRUE(queue.pop(got));
  EXPECT_EQ(got, 1);
  EXPECT_TRUE(queue.push(3));
}

TEST(SpscQueue, LosesNothingBetweenTwoThreads) {
  SpscQueue<int, 8> queue;
  std::thread writer([&] {
    for (int i = 0; i < 50000;) {
      i += queue.push(i) ? 1 : 0;
    }
  });
  int got = 0;
  for (int i = 0; i < 50000;) {
    if (queue.pop(got)) {
      ASSERT_EQ(got, i++);
    }
  }
  writer.join();
}

}  // namespace
}  // namespace robotui::rt::link
