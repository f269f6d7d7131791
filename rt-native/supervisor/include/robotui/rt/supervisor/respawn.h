// When a process that died is started again, and when no more.
#pragma once

#include <cstdint>
#include <deque>

namespace robotui::rt::supervisor {

class RespawnPolicy {
 public:
  static constexpr int kMostDeaths = 5;
  static constexpr std::int64_t kWindowNs = 10'000'000'000;
  static constexpr std::int64_t kFirstDelayNs = 100'000'000;

  // The first death is followed by a start at once, each further one of the window by twice the delay.
  void ended(std::int64_t now_ns);

  bool isGivenUp() const noexcept { return given_up_; }
  std::int64_t startAt() const noexcept { return start_at_ns_; }

  // The user wants it again.
  void reset() noexcept;

 private:
  std::deque<std::int64_t> deaths_;
  std::int64_t start_at_ns_ = 0;
  bool given_up_ = false;
};

}  // namespace robotui::rt::supervisor
