#include "stamp_gate.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr int kRisingAfterReset = 5;

}  // namespace

Stamp StampGate::take(Stamp as, std::int64_t stamp_ns, std::int64_t now_ns) noexcept {
  known_ = true;
  last_ns_ = stamp_ns;
  heard_ns_ = now_ns;
  rising_ = 0;
  return as;
}

Stamp StampGate::admit(std::int64_t stamp_ns, std::int64_t now_ns) noexcept {
  if (!known_ || stamp_ns > last_ns_) return take(Stamp::kNew, stamp_ns, now_ns);
  if (stamp_ns == last_ns_) return Stamp::kSame;
  if (now_ns - heard_ns_ > silence_ns_) return take(Stamp::kReset, stamp_ns, now_ns);
  rising_ = rising_ > 0 && stamp_ns > behind_ns_ ? rising_ + 1 : 1;
  behind_ns_ = stamp_ns;
  return rising_ >= kRisingAfterReset ? take(Stamp::kReset, stamp_ns, now_ns) : Stamp::kLate;
}

}  // namespace robotui::rt::hal::gazebo
