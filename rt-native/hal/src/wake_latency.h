// How deeply processors sleep while a cycle waits for its time.
#pragma once

#include <filesystem>

#include "real_time.h"
#include "robotui/rt/link/descriptor.h"

namespace robotui::rt::hal {

// Asks the kernel, as long as it lives, for no idle state of a processor from which it wakes later than this: from a
// deep one it can take longer than all the rest of a wake-up. Takes back by itself, also when the process is killed.
class WakeLatency {
 public:
  static constexpr const char* kDevice = "/dev/cpu_dma_latency";

  // Below zero asks nothing; a kernel without the device has nothing to be asked.
  explicit WakeLatency(int most_us, const std::filesystem::path& device = kDevice);

  // A sentence with the remedy where the device is refused: control goes on, but may wake late.
  const Refusal& refusal() const noexcept { return refusal_; }

 private:
  link::Descriptor device_;
  Refusal refusal_;
};

}  // namespace robotui::rt::hal
