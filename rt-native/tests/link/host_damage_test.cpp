#include "robotui/rt/link/host_damage.h"

#include <atomic>
#include <cstring>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/deadline.h"
#include "robotui/rt/link/histogram.h"
#include "robotui/rt/link/segment.h"

namespace robotui::rt::link {
namespace {

// As a host leaves it: a thread, a plugin, and figures.
Segment<HostSegment> written() {
  auto host = Segment<HostSegment>::create(1);
  host->threads = 1;
  ThreadStatistics& thread = host->thread_statistics[0];
  assign(thread.name, "rt_main");
  thread.period_ns = kMillisecond;
  thread.priority = 60;
  thread.core = -1;
  thread.inside.store(kNobody);
  for (std::int64_t i = 0; i < 100; ++i) record(thread.busy, i * 1000);
  host->plugins[3].state.store(static_cast<std::uint32_t>(PluginState::kRunning));
  return host;
}

TEST(HostDamage, is_none_in_what_a_host_writes_while_it_writes) {
  const auto host = written();
  EXPECT_EQ(damageOf(*host), "");
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (std::int64_t i = 0; !done; ++i) record(host->thread_statistics[0].wake_up, i % 1'000'000);
  });
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(damageOf(*host), "");
  done = true;
  writer.join();
}

TEST(HostDamage, is_none_in_a_thread_by_deadline) {
  const auto host = written();
  host->thread_statistics[0].priority = kByDeadline;
  EXPECT_EQ(damageOf(*host), "");
  host->thread_statistics[0].priority = kByDeadline + 1;
  EXPECT_EQ(damageOf(*host), "what it says of its threads is overwritten");
}

TEST(HostDamage, is_named_by_what_it_hit) {
  const auto head = written();
  head->header.magic = 7;
  EXPECT_EQ(damageOf(*head), "its head is overwritten");
  const auto threads = written();
  threads->threads = 9;
  EXPECT_EQ(damageOf(*threads), "the number of its threads is overwritten");
  const auto name = written();
  name->thread_statistics[0].name[2] = '\x1b';
  EXPECT_EQ(damageOf(*name), "what it says of its threads is overwritten");
  const auto endless = written();
  endless->thread_statistics[7].name.fill('x');
  EXPECT_EQ(damageOf(*endless), "what it says of its threads is overwritten");
  const auto figure = written();
  figure->thread_statistics[0].busy.buckets[5] = 70000;
  EXPECT_EQ(damageOf(*figure), "what it says of its threads is overwritten");
  const auto time = written();
  time->plugins[3].last_busy_ns = -1;
  EXPECT_EQ(damageOf(*time), "what it says of its plugins is overwritten");
}

TEST(HostDamage, can_be_anything_and_keeps_nobody_out) {
  std::mt19937 random(4711);
  for (int round = 0; round < 200; ++round) {
    const auto host = written();
    auto* const bytes = reinterpret_cast<unsigned char*>(host.get());
    const std::size_t length = 1 + random() % 4096;
    const std::size_t begin = random() % (sizeof(HostSegment) - length);
    for (std::size_t i = 0; i < length; ++i) bytes[begin + i] = static_cast<unsigned char>(random());
    const auto reader = Segment<const HostSegment>::openAsItIs(host.shareReadOnly());
    const bool is_behind_the_slots =
        begin >= offsetof(HostSegment, thread_statistics) && length > sizeof(PluginStatistics);
    EXPECT_TRUE(!is_behind_the_slots || !damageOf(*reader).empty()) << begin << " " << length;
  }
}

}  // namespace
}  // namespace robotui::rt::link
