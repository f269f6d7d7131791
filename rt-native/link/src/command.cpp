#include "robotui/rt/link/command.h"

#include <algorithm>
#include <cstddef>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/futex.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::link {

namespace {

constexpr std::size_t kCommandHead = offsetof(CommandData, joints);
constexpr std::size_t kMasterHead = offsetof(MasterData, joints);
static_assert(kCommandHead % sizeof(Word) == 0 && kMasterHead % sizeof(Word) == 0 &&
              sizeof(JointCommand) % sizeof(Word) == 0);

}  // namespace

SlotWriter::SlotWriter(HostSegment& host, std::uint32_t thread, std::uint32_t joints) noexcept
    : host_(&host), slot_(&host.slots[std::min(thread, kMaxThreads - 1)]), joints_(std::min(joints, kMaxJoints)) {}

void SlotWriter::write(const CommandData& commands) noexcept {
  const std::size_t bytes = kCommandHead + joints_ * sizeof(JointCommand);
  lockedWrite(slot_->sequence, [&]() noexcept { relaxedCopyIn(&slot_->data, &commands, bytes); });
  ringBell(host_->bell);
}

SlotReader::SlotReader(const HostSegment& host, std::uint32_t thread, std::uint32_t joints) noexcept
    : host_(&host), slot_(&host.slots[std::min(thread, kMaxThreads - 1)]), joints_(std::min(joints, kMaxJoints)) {}

Read SlotReader::read(CommandData& into) noexcept {
  return readLocked(slot_->sequence, slot_->data, into, kCommandHead + joints_ * sizeof(JointCommand), last_);
}

bool SlotReader::hasNew() const noexcept {
  const std::uint64_t sequence = slot_->sequence.load(std::memory_order_acquire);
  return (sequence & 1) == 0 && sequence != last_;
}

// The clock decides, not the bell alone: a host that rings without end must not keep its reader.
bool SlotReader::wait(std::int64_t deadline_ns) const noexcept {
  do {
    const std::uint32_t seen = host_->bell.load(std::memory_order_acquire);
    if (hasNew()) return true;
    if (!waitForBell(host_->bell, seen, deadline_ns)) break;
  } while (now() < deadline_ns);
  return hasNew();
}

MasterWriter::MasterWriter(MasterSegment& segment, std::uint32_t joints) noexcept
    : segment_(&segment), joints_(std::min(joints, kMaxJoints)) {}

void MasterWriter::write(const MasterData& data) noexcept {
  const std::size_t bytes = kMasterHead + joints_ * sizeof(JointCommand);
  lockedWrite(segment_->sequence, [&]() noexcept { relaxedCopyIn(&segment_->data, &data, bytes); });
}

MasterReader::MasterReader(const MasterSegment& segment, std::uint32_t joints) noexcept
    : segment_(&segment), joints_(std::min(joints, kMaxJoints)) {}

Read MasterReader::read(MasterData& into) noexcept {
  return readLocked(segment_->sequence, segment_->data, into, kMasterHead + joints_ * sizeof(JointCommand), last_);
}

}  // namespace robotui::rt::link
