// A robot whose joints are controlled by another computer, over UDP.
#pragma once

#include <optional>
#include <vector>

#include "datagram.h"
#include "packets.h"
#include "robotui/rt/hal/hal.h"
#include "sequence_gate.h"

namespace robotui::rt::hal::udp {

// Parameters: `address` (127.0.0.1), `port` (9870), `timeout_us` (five periods): without a state for that long, sense()
// says kTimeout.
class Udp : public Hal {
 public:
  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  Status sense(Measurements& into) noexcept override;
  Status move(std::span<const Reference> references) noexcept override;
  void senseStops(std::span<StopInput> into) noexcept override;
  void close() noexcept override { socket_.reset(); }

  std::uint64_t refused() const noexcept { return unreadable_ + gate_.refused(); }
  std::uint64_t lost() const noexcept { return gate_.lost(); }

 private:
  void greet(const config::RobotDescription& robot, const std::string& peer);
  bool heard(std::span<const std::byte> packet, Measurements& into) noexcept;
  Header header() noexcept;

  std::optional<Datagram> socket_;
  std::vector<config::EmergencyStop> stops_;
  SequenceGate gate_{0};
  Buffer outgoing_{};
  Buffer incoming_{};
  Header state_{};  // of the last state
  std::uint64_t cycle_ = 0;
  std::uint64_t sequence_ = 0;
  std::uint64_t unreadable_ = 0;
  std::uint32_t session_ = 0;
};

}  // namespace robotui::rt::hal::udp
