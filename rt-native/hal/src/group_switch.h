// Decides in which cycle a group of plugins is switched, and to whom its joints belong from then on. The board follows
// later, written by a thread that is not real time.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "command_inbox.h"
#include "robotui/rt/link/group_order.h"
#include "robotui/rt/link/spsc_queue.h"

namespace robotui::rt::hal {

class GroupSwitch {
 public:
  // ---- on one ordinary thread. False: it has no room.
  bool order(const link::GroupOrder& order) noexcept { return orders_.push({order, false}); }
  bool cancel(std::uint32_t group) noexcept;
  bool take(link::GroupOutcome& into) noexcept { return outcomes_.pop(into); }

  // ---- on the real-time thread, before owners are asked for: decides. `all_safe`: nobody can lead joints now.
  void look(std::uint64_t cycle, const CommandInbox& inbox, bool all_safe) noexcept;

  // Owner and grant of a joint: those of the board, until a group was switched that the board does not know of yet.
  std::pair<std::uint16_t, std::uint32_t> holder(std::uint32_t joint, std::uint16_t owner,
                                                 std::uint32_t grant) noexcept;

  // The last group that was switched; 0 is none.
  std::uint32_t switched() const noexcept { return switched_; }

 private:
  struct Request {
    link::GroupOrder order;
    bool is_cancelled;  // the group of that number
  };
  struct Progress {
    std::uint64_t cycles = 0;      // of the thread
    std::uint64_t changed_at = 0;  // cycle of the HAL; 0 is never
    bool is_known = false;
  };
  struct Handed {
    std::uint16_t before = link::kNobody;
    std::uint16_t owner = link::kNobody;
    std::uint32_t grant = 0;  // of the board before
    bool is_new = false;      // the board was not looked at since the switch
    bool counts = false;
  };

  void takeRequests(std::uint64_t cycle, const CommandInbox& inbox) noexcept;
  void begin(const link::GroupOrder& order, const CommandInbox& inbox) noexcept;
  bool isReady(std::uint16_t plugin, std::uint64_t cycle, const CommandInbox& inbox) noexcept;
  std::bitset<link::kMaxPlugins> lacking(std::uint64_t cycle, const CommandInbox& inbox) noexcept;
  void end(link::GroupRefusal refusal, std::uint64_t cycle, const std::bitset<link::kMaxPlugins>& lacking) noexcept;
  void handOver() noexcept;

  link::SpscQueue<Request, 8> orders_;
  link::SpscQueue<link::GroupOutcome, 8> outcomes_;
  link::GroupOrder pending_{};  // group 0: none
  std::array<Progress, link::kMaxPlugins> progress_{};
  std::array<Handed, link::kMaxJoints> handed_{};
  std::uint32_t switched_ = 0;
};

}  // namespace robotui::rt::hal
