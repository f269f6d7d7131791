#include "robotui/rt/plugin/log_queue.h"

#include <gtest/gtest.h>

#include <map>
#include <thread>
#include <vector>

#include "robotui/rt/link/allocations.h"

namespace robotui::rt {
namespace {

TEST(LogQueue, KeepsTheLinesInOrderWithTheirSource) {
  LogQueue queue;
  TaggedLog log(queue, 7);
  log.info("first");
  log.error("second");
  LogQueue::Line line;
  ASSERT_TRUE(queue.pop(line));
  EXPECT_EQ(line.view(), "first");
  EXPECT_EQ(line.source, 7u);
  ASSERT_TRUE(queue.pop(line));
  EXPECT_EQ(line.level, LogLevel::kError);
  EXPECT_FALSE(queue.pop(line));
}

TEST(LogQueue, AsksNothingOfTheHeapInACycle) {
  LogQueue queue;
  TaggedLog log(queue, 7);
  const std::uint64_t before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    for (std::size_t i = 0; i < 2 * LogQueue::kLines; ++i) log.warn("a line that may find no room");
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

TEST(LogQueue, CutsALongLine) {
  LogQueue queue;
  queue.push(LogLevel::kInfo, 0, std::string(1000, 'x'));
  LogQueue::Line line;
  ASSERT_TRUE(queue.pop(line));
  EXPECT_EQ(line.view(), std::string(LogQueue::kLineLength, 'x'));
}

TEST(LogQueue, CountsWhatFindsNoRoomAndGoesOnAfterwards) {
  LogQueue queue;
  for (std::size_t i = 0; i < LogQueue::kLines + 5; ++i) {
    queue.push(LogLevel::kInfo, 0, "line");
  }
  EXPECT_EQ(queue.takeLost(), 5u);
  EXPECT_EQ(queue.takeLost(), 0u);
  LogQueue::Line line;
  std::size_t count = 0;
  while (queue.pop(line)) {
    ++count;
  }
  EXPECT_EQ(count, LogQueue::kLines);
  EXPECT_TRUE(queue.push(LogLevel::kInfo, 0, "again"));
}

TEST(LogQueue, TakesLinesOfManyThreadsEachInItsOrder) {
  LogQueue queue;
  std::atomic<int> left{4};
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 2000; ++i) {
        while (!queue.push(LogLevel::kInfo, t, std::to_string(i))) {
          std::this_thread::yield();
        }
      }
      --left;
    });
  }
  std::map<std::uint32_t, int> next;
  LogQueue::Line line;
  for (bool more = true; more;) {
    more = left > 0;
    while (queue.pop(line)) {
      ASSERT_EQ(line.view(), std::to_string(next[line.source]++));
    }
  }
  for (auto& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(next[0] + next[1] + next[2] + next[3], 8000);
}

}  // namespace
}  // namespace robotui::rt
