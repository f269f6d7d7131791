// The board as the supervisor keeps it: filled from the configuration, changed in place, published when something
// changed.
#pragma once

#include <string_view>

#include "robotui/rt/config/plan.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/segment.h"

namespace robotui::rt::supervisor {

class BoardPublisher {
 public:
  BoardPublisher(const config::RtConfig& config, const config::Plan& plan, bool real_time);

  const link::BoardData& data() noexcept { return writer_.edit(); }
  link::BoardData& edit() noexcept {
    dirty_ = true;
    return writer_.edit();
  }
  void publish() noexcept;

  void grant(std::uint32_t joint, std::uint32_t plugin) noexcept {
    writer_.grant(joint, static_cast<std::uint16_t>(plugin));
  }
  void release(std::uint32_t joint, std::uint32_t plugin) noexcept;
  std::uint16_t owner(std::uint32_t joint) const noexcept {
    return segment_->owners[joint].load(std::memory_order_relaxed);
  }

  std::uint32_t grantOf(std::uint32_t joint) const noexcept {
    return segment_->grants[joint].load(std::memory_order_relaxed);
  }

  link::Descriptor share() const { return segment_.shareReadOnly(); }

 private:
  link::Segment<link::BoardSegment> segment_;
  link::BoardWriter writer_;
  bool dirty_ = true;
};

}  // namespace robotui::rt::supervisor
