#include "wake_latency.h"

#include <cerrno>
#include <cstdint>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace robotui::rt::hal {

namespace {

constexpr const char* kRemedy =
    " Allow it with a udev rule (KERNEL==\"cpu_dma_latency\", GROUP=\"realtime\", MODE=\"0660\"), or bear it with "
    "cpu_dma_latency_us: -1.";

}  // namespace

WakeLatency::WakeLatency(int most_us, const std::filesystem::path& device) {
  if (most_us < 0) return;
  device_ = link::Descriptor(::open(device.c_str(), O_WRONLY | O_CLOEXEC));
  const auto asked = static_cast<std::int32_t>(most_us);
  if (device_.isOpen() && ::write(device_.get(), &asked, sizeof(asked)) == static_cast<ssize_t>(sizeof(asked))) return;
  const int error = errno;
  if (error == ENOENT) return;
  refusal_ = "Processors may sleep deeply between two cycles and wake late, since " + device.string() +
             " is refused: " + std::strerror(error) + "." + kRemedy;
}

}  // namespace robotui::rt::hal
