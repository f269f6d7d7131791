#include "robotui/rt/link/state.h"

#include <algorithm>
#include <cstddef>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/futex.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::link {

namespace {

constexpr std::size_t kHead = offsetof(FrameData, joints);
static_assert(kHead % sizeof(Word) == 0 && sizeof(JointState) % sizeof(Word) == 0);
static_assert(sizeof(ImuState) % sizeof(Word) == 0 && sizeof(ForceTorqueState) % sizeof(Word) == 0);

void copyIn(FrameData& to, const FrameData& from, const Counts& counts) noexcept {
  relaxedCopyIn(&to, &from, kHead);
  relaxedCopyIn(to.joints.data(), from.joints.data(), counts.joints * sizeof(JointState));
  relaxedCopyIn(to.imus.data(), from.imus.data(), counts.imus * sizeof(ImuState));
  relaxedCopyIn(to.force_torques.data(), from.force_torques.data(), counts.force_torques * sizeof(ForceTorqueState));
}

void copyOut(FrameData& to, const FrameData& from, const Counts& counts) noexcept {
  relaxedCopyOut(&to, &from, kHead);
  relaxedCopyOut(to.joints.data(), from.joints.data(), counts.joints * sizeof(JointState));
  relaxedCopyOut(to.imus.data(), from.imus.data(), counts.imus * sizeof(ImuState));
  relaxedCopyOut(to.force_torques.data(), from.force_torques.data(), counts.force_torques * sizeof(ForceTorqueState));
}

}  // namespace

Counts bounded(const Counts& counts) noexcept {
  return {std::min(counts.joints, kMaxJoints), std::min(counts.imus, kMaxImus),
          std::min(counts.force_torques, kMaxForceTorques)};
}

StateWriter::StateWriter(StateSegment& segment, const Counts& counts) noexcept
    : segment_(&segment), counts_(bounded(counts)) {
  relaxedStore(segment.joints, counts_.joints);
  relaxedStore(segment.imus, counts_.imus);
  relaxedStore(segment.force_torques, counts_.force_torques);
}

void StateWriter::publish(const FrameData& frame) noexcept {
  StateFrame& place = segment_->frames[frame.cycle % kFrames];
  lockedWrite(place.sequence, [&]() noexcept { copyIn(place.data, frame, counts_); });
  segment_->newest.store(frame.cycle, std::memory_order_release);
}

void StateWriter::ring() noexcept { ringBell(segment_->bell); }

StateReader::StateReader(const StateSegment& segment) noexcept
    : segment_(&segment),
      counts_(bounded({relaxedLoad(segment.joints), relaxedLoad(segment.imus), relaxedLoad(segment.force_torques)})) {}

bool StateReader::copy(std::uint64_t cycle, FrameData& into) const noexcept {
  const StateFrame& place = segment_->frames[cycle % kFrames];
  const bool whole = lockedRead(place.sequence, [&]() noexcept { copyOut(into, place.data, counts_); }) != 0;
  return whole && into.cycle == cycle;  // another cycle: the writer was round the ring in the meantime
}

// Counts of a hostile or mended segment may run backwards: that loses nothing.
Read StateReader::took(std::uint64_t cycle) noexcept {
  if (last_ != 0 && cycle > last_ + 1) lost_ += cycle - last_ - 1;
  last_ = cycle;
  return Read::kNew;
}

Read StateReader::newest(FrameData& into) noexcept {
  for (int i = 0; i < kReadTries; ++i) {
    const std::uint64_t cycle = segment_->newest.load(std::memory_order_acquire);
    if (cycle == 0) return Read::kNone;
    if (cycle == last_) return Read::kSame;
    if (copy(cycle, into)) return took(cycle);
  }
  return Read::kBusy;
}

Read StateReader::next(FrameData& into) noexcept {
  for (int i = 0; i < kReadTries; ++i) {
    const std::uint64_t newest_cycle = segment_->newest.load(std::memory_order_acquire);
    if (newest_cycle == 0) return Read::kNone;
    if (newest_cycle == last_) return Read::kSame;
    // The place of the oldest frame may be written right now, so that is not tried.
    const std::uint64_t oldest = newest_cycle > kFrames - 2 ? newest_cycle - (kFrames - 2) : 1;
    const std::uint64_t cycle = last_ == 0 ? newest_cycle : std::clamp(last_ + 1, oldest, newest_cycle);
    if (copy(cycle, into)) return took(cycle);
  }
  return Read::kBusy;
}

bool StateReader::wait(std::int64_t deadline_ns) const noexcept {
  do {
    const std::uint32_t seen = segment_->bell.load(std::memory_order_acquire);
    if (segment_->newest.load(std::memory_order_acquire) != last_) return true;
    if (!waitForBell(segment_->bell, seen, deadline_ns)) break;
  } while (now() < deadline_ns);
  return segment_->newest.load(std::memory_order_acquire) != last_;
}

}  // namespace robotui::rt::link
