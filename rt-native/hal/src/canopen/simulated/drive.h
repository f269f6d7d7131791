// A drive of CiA 402 on a bus, simulated: it answers SDO, obeys NMT, exchanges PDOs on SYNC, watches its control, and
// fails when it is told to.
#pragma once

#include <cstdint>
#include <functional>

#include "../frame.h"
#include "dictionary.h"
#include "motor.h"

namespace robotui::rt::hal::canopen::simulated {

// What a test may make of it.
struct Ailments {
  bool is_silent = false;       // nothing comes from it: cut off
  bool sends_no_state = false;  // no PDOs
  bool sends_no_heartbeat = false;
};

class Drive {
 public:
  using Send = std::function<void(const Frame&)>;

  Drive(std::uint8_t node, double position_counts, Send send);

  void heard(const Frame& frame, std::int64_t now_ns);
  void step(std::int64_t now_ns);

  void fail(std::uint16_t code);  // with an emergency message
  void restart();                 // as when its supply was off and comes back
  Ailments& ailments() noexcept { return ailments_; }
  Motor& motor() noexcept { return motor_; }
  Dictionary& dictionary() noexcept { return dictionary_; }
  std::uint8_t node() const noexcept { return node_; }
  NmtState nmt() const noexcept { return nmt_; }

 private:
  void send(const Frame& frame) const;
  void obeyNmt(const Frame& frame);
  void sync(std::int64_t now_ns);
  void take(const Frame& frame);
  void sendStates();
  void publishState();
  void emergency(std::uint16_t code);
  void watchControl(std::int64_t now_ns);
  bool isOperational() const noexcept { return nmt_ == NmtState::kOperational; }

  std::uint8_t node_;
  Send send_;
  Dictionary dictionary_;
  Motor motor_;
  Ailments ailments_;
  NmtState nmt_ = NmtState::kPreOperational;
  std::int64_t beat_ns_ = 0;
  std::int64_t control_ns_ = 0;  // of the last heartbeat of the control; 0 is none yet
  std::int64_t moved_ns_ = 0;
  std::uint16_t error_ = 0;
};

}  // namespace robotui::rt::hal::canopen::simulated
