// Writing and reading the state: a ring of frames behind sequence locks.
#pragma once

#include <cstdint>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/seqlock.h"

namespace robotui::rt::link {

// How many there are of each; never more than the layout has room for.
struct Counts {
  std::uint32_t joints = 0;
  std::uint32_t imus = 0;
  std::uint32_t force_torques = 0;
};

// What of `counts` fits the layout: for numbers from memory of another process.
Counts bounded(const Counts& counts) noexcept;

// The one writer. Neither waits nor allocates.
class StateWriter {
 public:
  StateWriter(StateSegment& segment, const Counts& counts) noexcept;

  // Puts a frame into the ring: its `cycle` is greater than that of the one before, from 1. Only what `counts` names is
  // copied.
  void publish(const FrameData& frame) noexcept;

  // Wakes all readers that wait.
  void ring() noexcept;

  LoopStatistics& loop() noexcept { return segment_->loop; }

 private:
  StateSegment* segment_;
  Counts counts_;
};

// One of many readers, each with its own place in the ring. For one thread; neither allocates nor, but in wait(),
// sleeps.
class StateReader {
 public:
  explicit StateReader(const StateSegment& segment) noexcept;

  const Counts& counts() const noexcept { return counts_; }

  // Copies the newest frame. kSame where the reader has had it.
  Read newest(FrameData& into) noexcept;

  // Copies the frame after the last one read, or the oldest there is where that one was overwritten: for those who want
  // every frame.
  Read next(FrameData& into) noexcept;

  // Sleeps until there is a frame that was not read, or the deadline (CLOCK_MONOTONIC); true where there is one.
  bool wait(std::int64_t deadline_ns) const noexcept;

  std::uint64_t lastCycle() const noexcept { return last_; }

  // Frames that were published since the first read and not returned by this reader.
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  bool copy(std::uint64_t cycle, FrameData& into) const noexcept;
  Read took(std::uint64_t cycle) noexcept;

  const StateSegment* segment_;
  Counts counts_;
  std::uint64_t last_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace robotui::rt::link
