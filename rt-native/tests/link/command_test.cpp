#include "robotui/rt/link/command.h"

#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::link {
namespace {

constexpr std::uint32_t kJoints = 30;

CommandData commandOf(std::uint64_t cycle) {
  CommandData data{};
  data.cycle = cycle;
  for (std::uint32_t j = 0; j < kJoints; ++j)
    data.joints[j].position = data.joints[j].damping = static_cast<double>(cycle);
  return data;
}

bool isWhole(const CommandData& data) {
  const auto value = static_cast<double>(data.cycle);
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    if (data.joints[j].position != value || data.joints[j].damping != value) return false;
  }
  return true;
}

struct Slot : testing::Test {
  std::unique_ptr<HostSegment> host = std::make_unique<HostSegment>();
  SlotWriter writer{*host, 2, kJoints};
  SlotReader reader{*host, 2, kJoints};
  CommandData out{};
};

TEST_F(Slot, is_read_once) {
  EXPECT_EQ(reader.read(out), Read::kNone);
  writer.write(commandOf(5));
  EXPECT_TRUE(reader.hasNew());
  EXPECT_EQ(reader.read(out), Read::kNew);
  EXPECT_EQ(out.cycle, 5U);
  EXPECT_TRUE(isWhole(out));
  EXPECT_FALSE(reader.hasNew());
  EXPECT_EQ(reader.read(out), Read::kSame);
}

TEST_F(Slot, of_a_host_that_died_while_it_wrote_is_busy_and_never_new) {
  writer.write(commandOf(5));
  host->slots[2].sequence.fetch_add(1);
  EXPECT_FALSE(reader.hasNew());
  EXPECT_EQ(reader.read(out), Read::kBusy);
}

TEST_F(Slot, wakes_the_reader_that_waits_for_it) {
  std::jthread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    writer.write(commandOf(9));
  });
  EXPECT_TRUE(reader.wait(now() + 5 * kSecond));
  EXPECT_EQ(reader.read(out), Read::kNew);
}

TEST_F(Slot, of_another_thread_wakes_but_is_not_news) {
  SlotWriter other(*host, 3, kJoints);
  std::jthread late([&] { other.write(commandOf(9)); });
  EXPECT_FALSE(reader.wait(now() + 30 * kMillisecond));
}

TEST_F(Slot, is_never_read_torn) {
  std::jthread writing([&](const std::stop_token& stop) {
    for (std::uint64_t i = 1; !stop.stop_requested(); ++i) writer.write(commandOf(i));
  });
  bool whole = true;
  int reads = 0;
  for (const std::int64_t end = now() + kSecond / 2; whole && (now() < end || reads == 0);) {
    if (reader.read(out) != Read::kNew) continue;
    whole = isWhole(out);
    ++reads;
  }
  EXPECT_TRUE(whole);
}

TEST_F(Slot, numbers_beyond_the_layout_do_not_leave_it) {
  SlotReader beyond(*host, UINT32_MAX, UINT32_MAX);
  SlotWriter(*host, kMaxThreads - 1, kJoints).write(commandOf(1));
  EXPECT_EQ(beyond.read(out), Read::kNew);
}

TEST(Master, says_until_when_it_holds) {
  auto segment = std::make_unique<MasterSegment>();
  MasterWriter writer(*segment, kJoints);
  MasterReader reader(*segment, kJoints);
  MasterData data{};
  EXPECT_EQ(reader.read(data), Read::kNone);
  data.valid_until_ns = 77;
  data.joints[kJoints - 1].effort = 3;
  writer.write(data);
  MasterData out{};
  EXPECT_EQ(reader.read(out), Read::kNew);
  EXPECT_EQ(out.valid_until_ns, 77);
  EXPECT_EQ(out.joints[kJoints - 1].effort, 3);
}

}  // namespace
}  // namespace robotui::rt::link
