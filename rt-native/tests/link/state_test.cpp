#include "robotui/rt/link/state.h"

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::link {
namespace {

constexpr Counts kForty{40, 2, 4};

// Every number of a frame tells its cycle, so that a torn one shows.
void fill(FrameData& frame, std::uint64_t cycle) {
  frame.cycle = cycle;
  frame.sensed_ns = static_cast<std::int64_t>(cycle);
  for (std::uint32_t j = 0; j < kForty.joints; ++j) {
    JointState& joint = frame.joints[j];
    joint.link_position = joint.motor_position = joint.effort = joint.damping = static_cast<double>(cycle);
    joint.clamped = static_cast<std::uint32_t>(cycle);
  }
  frame.imus[1].linear_acceleration[2] = static_cast<double>(cycle);
  frame.force_torques[3].torque[2] = static_cast<double>(cycle);
}

bool isOf(const FrameData& frame, std::uint64_t cycle) {
  const auto value = static_cast<double>(cycle);
  for (std::uint32_t j = 0; j < kForty.joints; ++j) {
    const JointState& joint = frame.joints[j];
    if (joint.link_position != value || joint.motor_position != value || joint.effort != value ||
        joint.damping != value)
      return false;
    if (joint.clamped != static_cast<std::uint32_t>(cycle)) return false;
  }
  return frame.cycle == cycle && frame.imus[1].linear_acceleration[2] == value &&
         frame.force_torques[3].torque[2] == value;
}

struct State : testing::Test {
  std::unique_ptr<StateSegment> segment = std::make_unique<StateSegment>();
  StateWriter writer{*segment, kForty};
  StateReader reader{*segment};
  FrameData in{};
  FrameData out{};

  void publish(std::uint64_t cycle) {
    fill(in, cycle);
    writer.publish(in);
  }
};

TEST_F(State, has_nothing_before_the_first_frame) {
  EXPECT_EQ(reader.newest(out), Read::kNone);
  EXPECT_EQ(reader.next(out), Read::kNone);
}

TEST_F(State, newest_is_read_once_and_tells_what_was_missed) {
  publish(1);
  EXPECT_EQ(reader.newest(out), Read::kNew);
  EXPECT_EQ(reader.newest(out), Read::kSame);
  publish(2);
  publish(3);
  publish(4);
  EXPECT_EQ(reader.newest(out), Read::kNew);
  EXPECT_TRUE(isOf(out, 4));
  EXPECT_EQ(reader.lost(), 2U);
}

TEST_F(State, next_gives_every_frame_while_the_ring_holds_them) {
  publish(1);
  ASSERT_EQ(reader.next(out), Read::kNew);
  for (std::uint64_t cycle = 2; cycle < kFrames; ++cycle) publish(cycle);
  for (std::uint64_t cycle = 2; cycle < kFrames; ++cycle) {
    ASSERT_EQ(reader.next(out), Read::kNew);
    EXPECT_TRUE(isOf(out, cycle));
  }
  EXPECT_EQ(reader.next(out), Read::kSame);
  EXPECT_EQ(reader.lost(), 0U);
}

TEST_F(State, next_counts_what_was_overwritten) {
  publish(1);
  ASSERT_EQ(reader.next(out), Read::kNew);
  for (std::uint64_t cycle = 2; cycle <= 100; ++cycle) publish(cycle);
  std::uint64_t seen = 1;
  while (reader.next(out) == Read::kNew) {
    EXPECT_TRUE(isOf(out, out.cycle));
    ++seen;
  }
  EXPECT_EQ(out.cycle, 100U);
  EXPECT_EQ(seen + reader.lost(), 100U);
}

TEST_F(State, a_frame_that_is_never_finished_does_not_hang_a_reader) {
  publish(1);
  segment->frames[1].sequence.fetch_add(1);
  EXPECT_EQ(reader.newest(out), Read::kBusy);
}

TEST_F(State, counts_of_a_hostile_segment_stay_within_the_layout) {
  segment->joints = segment->imus = segment->force_torques = UINT32_MAX;
  const StateReader hostile(*segment);
  EXPECT_EQ(hostile.counts().joints, kMaxJoints);
  EXPECT_EQ(hostile.counts().imus, kMaxImus);
  EXPECT_EQ(hostile.counts().force_torques, kMaxForceTorques);
}

TEST_F(State, several_readers_never_see_a_torn_frame) {
  std::atomic<bool> done{false};
  std::atomic<bool> torn{false};
  std::atomic<std::uint64_t> reads{0};
  auto read = [&](bool every) {
    StateReader own(*segment);
    FrameData frame{};
    while (!done && !torn) {
      const Read result = every ? own.next(frame) : own.newest(frame);
      if (result != Read::kNew) continue;
      reads.fetch_add(1, std::memory_order_relaxed);
      if (!isOf(frame, frame.cycle)) torn = true;
    }
  };
  std::vector<std::jthread> readers;
  for (int i = 0; i < 3; ++i) readers.emplace_back(read, i == 0);
  const std::int64_t end = now() + kSecond;
  for (std::uint64_t cycle = 1; now() < end || reads == 0; ++cycle) publish(cycle);
  done = true;
  readers.clear();
  EXPECT_FALSE(torn);
}

TEST_F(State, a_waiting_reader_loses_no_frame_of_a_slow_writer) {
  constexpr std::uint64_t kCycles = 300;
  std::jthread waiting([&] {
    FrameData frame{};
    std::uint64_t expected = 1;
    while (expected <= kCycles && reader.wait(now() + 5 * kSecond)) {
      while (reader.next(frame) == Read::kNew) expected = frame.cycle + 1;
    }
    EXPECT_EQ(expected, kCycles + 1);
  });
  for (std::uint64_t cycle = 1; cycle <= kCycles; ++cycle) {
    publish(cycle);
    writer.ring();
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  waiting.join();
  EXPECT_LT(reader.lost(), kCycles / 10);
}

TEST_F(State, waiting_ends_at_the_deadline) {
  publish(1);
  ASSERT_EQ(reader.newest(out), Read::kNew);
  const std::int64_t begin = now();
  EXPECT_FALSE(reader.wait(begin + 20 * kMillisecond));
  EXPECT_GE(now() - begin, 20 * kMillisecond);
}

}  // namespace
}  // namespace robotui::rt::link
