#include "robotui/rt/supervisor/respawn.h"

namespace robotui::rt::supervisor {

void RespawnPolicy::ended(std::int64_t now_ns) {
  while (!deaths_.empty() && now_ns - deaths_.front() > kWindowNs) {
    deaths_.pop_front();
  }
  const auto before = deaths_.size();
  deaths_.push_back(now_ns);
  given_up_ = deaths_.size() >= kMostDeaths;
  start_at_ns_ = now_ns + (before == 0 ? 0 : kFirstDelayNs << (before - 1));
}

void RespawnPolicy::reset() noexcept {
  deaths_.clear();
  start_at_ns_ = 0;
  given_up_ = false;
}

}  // namespace robotui::rt::supervisor
