// Writing and reading the board: what there is, who owns which joint, and how all are.
#pragma once

#include <cstdint>
#include <string_view>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/seqlock.h"

namespace robotui::rt::link {

// Copies as much as fits, without cutting a UTF-8 character; always zero terminated.
void assign(Name& into, std::string_view text) noexcept;
void assign(Text& into, std::string_view text) noexcept;

// Up to the first zero byte, or all of it where another process left none.
std::string_view view(const Name& name) noexcept;
std::string_view view(const Text& text) noexcept;

// The one writer, of one thread.
class BoardWriter {
 public:
  // Nobody owns a joint yet.
  explicit BoardWriter(BoardSegment& segment) noexcept;

  // Own copy: change it, then publish() it whole.
  BoardData& edit() noexcept { return data_; }
  void publish() noexcept;

  // Gives a joint to a plugin: ends its safe state. Seen by the HAL in its next cycle.
  void grant(std::uint32_t joint, std::uint16_t plugin) noexcept;

  // Nobody owns it now: it holds.
  void release(std::uint32_t joint) noexcept;

 private:
  BoardSegment* segment_;
  BoardData data_{};
};

class BoardReader {
 public:
  explicit BoardReader(const BoardSegment& segment) noexcept : segment_(&segment) {}

  // Counts of the copy are within the layout's, whatever stands there.
  Read read(BoardData& into) noexcept;

  std::uint16_t owner(std::uint32_t joint) const noexcept {
    return segment_->owners[joint].load(std::memory_order_relaxed);
  }

  // Read it before the owner: who sees a new grant then sees its owner, too.
  std::uint32_t grant(std::uint32_t joint) const noexcept {
    return segment_->grants[joint].load(std::memory_order_acquire);
  }

 private:
  const BoardSegment* segment_;
  std::uint64_t last_ = 0;
};

}  // namespace robotui::rt::link
