// One end of a CAN bus: a socket of the kernel's SocketCAN, or of a simulated bus that carries the same frames.
#pragma once

#include <string>
#include <string_view>

#include "frame.h"
#include "robotui/rt/link/descriptor.h"

namespace robotui::rt::hal::canopen {

inline constexpr std::string_view kSimulatedBus = "unix:";

enum class Sent : std::uint8_t { kYes, kFull, kDown };
enum class Heard : std::uint8_t { kFrame, kNothing, kDown };

// Neither waits nor allocates, but where it is opened, and in wait().
class Bus {
 public:
  // `interface` is one of the kernel, such as can0, or unix:PATH, the socket of a simulated bus. Each of them hears the
  // others' frames and not its own. Throws std::runtime_error.
  static Bus open(const std::string& interface);

  // An end that exists: one of a pair of sockets of the type SEQPACKET.
  explicit Bus(link::Descriptor descriptor) noexcept : descriptor_(std::move(descriptor)) {}

  // Of a bus of the kernel: the others do not wake it. `mask` says which bits of an identifier are those of `id`.
  void hearOnly(canid_t id, canid_t mask) const noexcept;

  Sent send(const Frame& frame) const noexcept;

  // What is no frame is passed over, and so is what the bus had for others, a bounded number of times.
  Heard receive(Frame& into) const noexcept;

  bool wait(int timeout_ms) const noexcept;
  int descriptor() const noexcept { return descriptor_.get(); }

 private:
  link::Descriptor descriptor_;
};

}  // namespace robotui::rt::hal::canopen
