// What a cycle has to tell of joints that fell and of commands that were refused, for the ordinary thread.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "joint_control.h"
#include "robotui/rt/link/joint_event.h"
#include "robotui/rt/link/spsc_queue.h"

namespace robotui::rt::hal {

// Neither waits nor allocates, but when it is made.
class JointFalls {
 public:
  // While the commands of a joint are refused, that is said again after so many cycles.
  JointFalls(std::uint32_t joints, std::uint64_t say_again_after);

  // ---- on the real-time thread, between begin() and end() of a cycle
  void begin(std::uint64_t cycle, const link::StopBits& stops = {}) noexcept {
    cycle_ = cycle;
    stops_ = stops;
  }
  void refused(std::uint32_t joint, const JointControl& control) noexcept;
  void fell(std::uint32_t joint, const JointControl& control, link::FallCause cause, double error) noexcept;
  bool hasFallen(std::uint16_t plugin) const noexcept;  // since begin()
  void fellToo(std::uint32_t joint, std::uint16_t plugin) noexcept;
  void end() noexcept;

  // ---- on one ordinary thread
  bool take(link::JointEvent& into) noexcept { return queue_.pop(into); }

 private:
  link::JointEvent eventOf(std::uint32_t joint, const JointControl& control) const noexcept;

  std::uint64_t cycle_ = 0;
  link::StopBits stops_{};
  std::uint64_t say_again_after_;
  std::vector<std::uint64_t> said_;                           // cycle, by joint; 0 is never
  std::array<link::JointEvent, link::kMaxPlugins> fallen_{};  // of this cycle, or that found no room in the queue
  std::size_t count_ = 0;
  link::SpscQueue<link::JointEvent, 256> queue_;
};

}  // namespace robotui::rt::hal
