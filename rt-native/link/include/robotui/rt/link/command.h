// Writing and reading what joints are to do: a slot for each plugin thread, and the master framework's references.
#pragma once

#include <cstdint>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/seqlock.h"

namespace robotui::rt::link {

// Of one plugin thread. Neither waits nor allocates.
class SlotWriter {
 public:
  SlotWriter(HostSegment& host, std::uint32_t thread, std::uint32_t joints) noexcept;

  // Writes the first `joints` commands and rings the host's bell, on which the HAL may wait.
  void write(const CommandData& commands) noexcept;

 private:
  HostSegment* host_;
  CommandSlot* slot_;
  std::uint32_t joints_;
};

// What a thread last commanded. The numbers are what another process wrote: check each.
class SlotReader {
 public:
  SlotReader(const HostSegment& host, std::uint32_t thread, std::uint32_t joints) noexcept;

  Read read(CommandData& into) noexcept;

  // Whether something was written since the last read: cheap.
  bool hasNew() const noexcept;

  // Sleeps until the host wrote something (into any of its slots) after this one was looked at, or until the deadline;
  // true where this slot has news.
  bool wait(std::int64_t deadline_ns) const noexcept;

 private:
  const HostSegment* host_;
  const CommandSlot* slot_;
  std::uint32_t joints_;
  std::uint64_t last_ = 0;
};

class MasterWriter {
 public:
  MasterWriter(MasterSegment& segment, std::uint32_t joints) noexcept;
  void write(const MasterData& data) noexcept;

 private:
  MasterSegment* segment_;
  std::uint32_t joints_;
};

class MasterReader {
 public:
  MasterReader(const MasterSegment& segment, std::uint32_t joints) noexcept;
  Read read(MasterData& into) noexcept;

 private:
  const MasterSegment* segment_;
  std::uint32_t joints_;
  std::uint64_t last_ = 0;
};

}  // namespace robotui::rt::link
