// The HAL as the supervisor sees it: started, given the board and the hosts, watched.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robotui/rt/link/segment.h"
#include "robotui/rt/link/state.h"
#include "robotui/rt/supervisor/child.h"
#include "robotui/rt/supervisor/respawn.h"

namespace robotui::rt::supervisor {

class HalProcess {
 public:
  // `segments` are the board and those of the hosts, in order.
  void spawn(const std::vector<std::string>& arguments, const std::vector<int>& segments);

  Child& child() noexcept { return child_; }
  RespawnPolicy& respawns() noexcept { return respawns_; }
  bool isOpen() const noexcept { return static_cast<bool>(state_); }
  const link::Segment<const link::StateSegment>& state() const noexcept { return state_; }
  const std::string& failure() const noexcept { return failure_; }  // what it said when it could not open

  // Where its drives stand, as it said last; empty where it has none.
  const std::string& drives() const noexcept { return drives_; }

  // Takes its state; throws link::SegmentError where that is none.
  void handle(link::Packet& packet);

  // Kills it where it does not cycle any more, or never opens.
  void watch(std::int64_t now_ns);

  void ended(std::int64_t now_ns);

  std::uint64_t cycle() const noexcept { return state_ ? state_->newest.load(std::memory_order_relaxed) : 0; }
  std::int64_t period() const noexcept;

 private:
  std::int64_t patience() const noexcept;

  Child child_;
  RespawnPolicy respawns_;
  link::Segment<const link::StateSegment> state_;
  std::string failure_;
  std::string drives_;
  std::uint64_t last_cycle_ = 0;
  std::int64_t progress_ns_ = 0;
};

}  // namespace robotui::rt::supervisor
