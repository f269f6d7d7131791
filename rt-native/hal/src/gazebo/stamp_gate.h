// Which states count: those whose simulated time goes on.
#pragma once

#include <cstdint>

namespace robotui::rt::hal::gazebo {

enum class Stamp : std::uint8_t {
  kNew,    // time went on
  kSame,   // time stands: the world is paused
  kLate,   // older than what is known: dropped
  kReset,  // time went back, and goes on from there
};

// A state that comes late is one among newer ones. After a reset, older ones follow each other with none that is newer.
class StampGate {
 public:
  // After that long without a newer one any stamp is taken: another simulator may be there.
  explicit StampGate(std::int64_t silence_ns) noexcept : silence_ns_(silence_ns) {}

  Stamp admit(std::int64_t stamp_ns, std::int64_t now_ns) noexcept;

 private:
  Stamp take(Stamp as, std::int64_t stamp_ns, std::int64_t now_ns) noexcept;

  std::int64_t silence_ns_;
  std::int64_t heard_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::int64_t behind_ns_ = 0;  // the newest of those that are older than last_ns_
  int rising_ = 0;              // how many of those followed each other
  bool known_ = false;
};

}  // namespace robotui::rt::hal::gazebo
