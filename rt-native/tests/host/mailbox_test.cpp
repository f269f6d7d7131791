#include "robotui/rt/host/mailbox.h"

#include <gtest/gtest.h>

#include <thread>

namespace robotui::rt::host {
namespace {

TEST(Mailbox, GivesWhatWasPutInUntilItIsFull) {
  Mailbox<int, 2> box;
  int got = 0;
  EXPECT_FALSE(box.pop(got));
  EXPECT_TRUE(box.push(1));
  EXPECT_TRUE(box.push(2));
  EXPECT_FALSE(box.push(3));
  EXPECT_TRUE(box.pop(got));
  EXPECT_EQ(got, 1);
  EXPECT_TRUE(box.push(3));
}

TEST(Mailbox, LosesNothingBetweenTwoThreads) {
  Mailbox<int, 8> box;
  std::thread writer([&] {
    for (int i = 0; i < 50000;) {
      i += box.push(i) ? 1 : 0;
    }
  });
  int got = 0;
  for (int i = 0; i < 50000;) {
    if (box.pop(got)) {
      ASSERT_EQ(got, i++);
    }
  }
  writer.join();
}

TEST(Words, AreCutToTheirLength) {
  Words<4> words;
  words.assign("abcdef");
  EXPECT_EQ(words.view(), "abcd");
}

}  // namespace
}  // namespace robotui::rt::host
