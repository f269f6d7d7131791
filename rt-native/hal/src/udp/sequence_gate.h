// Which packets of the other side count: each once, none that is older than one before, and one sender at a time.
#pragma once

#include <cstdint>

namespace robotui::rt::hal::udp {

class SequenceGate {
 public:
  // A sender that was silent that long may be followed by another one (or by itself, started anew).
  explicit SequenceGate(std::int64_t silence_ns) noexcept : silence_ns_(silence_ns) {}

  // `sender` is its address, `session` its start.
  bool admit(std::uint64_t sender, std::uint32_t session, std::uint64_t sequence, std::int64_t now_ns) noexcept {
    const bool same = known_ && sender == sender_ && session == session_;
    if (same ? sequence <= last_ : !isSilent(now_ns)) {
      ++refused_;
      return false;
    }
    if (same) lost_ += sequence - last_ - 1;
    known_ = true;
    sender_ = sender;
    session_ = session;
    last_ = sequence;
    heard_ns_ = now_ns;
    return true;
  }

  bool isSilent(std::int64_t now_ns) const noexcept { return !known_ || now_ns - heard_ns_ > silence_ns_; }
  std::uint32_t session() const noexcept { return session_; }
  std::uint64_t refused() const noexcept { return refused_; }  // late, twice, or of another sender
  std::uint64_t lost() const noexcept { return lost_; }        // gaps in the sequence, also those that came late

 private:
  std::int64_t silence_ns_;
  std::int64_t heard_ns_ = 0;
  std::uint64_t sender_ = 0;
  std::uint64_t last_ = 0;
  std::uint64_t refused_ = 0;
  std::uint64_t lost_ = 0;
  std::uint32_t session_ = 0;
  bool known_ = false;
};

}  // namespace robotui::rt::hal::udp
