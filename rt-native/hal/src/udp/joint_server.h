// The other side of the UDP HAL, simulated: joints that follow, and hold by themselves when nobody commands them.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "../dummy/joint_motion.h"
#include "datagram.h"
#include "packets.h"
#include "robotui/rt/config/config.h"
#include "sequence_gate.h"

namespace robotui::rt::hal::udp {

struct JointServerSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 9870;  // 0 takes a free one
  std::int64_t watchdog_ns = 50'000'000;
  std::string posture;
};

class JointServer {
 public:
  // Throws std::runtime_error.
  JointServer(const config::RobotDescription& robot, const JointServerSettings& settings);

  std::uint16_t port() const { return socket_.port(); }

  // Answers for a millisecond at least, moves the joints by the time that went.
  void step();

  // The inputs of emergency stops, a bit each: 1 where the circuit is closed, as all are at first.
  void wire(std::uint16_t circuits) noexcept { circuits_ = circuits; }

  bool holds() const noexcept { return holding_; }
  std::uint64_t refused() const noexcept { return unreadable_ + gate_.refused(); }

 private:
  void heard(std::span<const std::byte> packet, const sockaddr_in& from);
  void obey(std::span<const std::byte> packet, const Header& header, const sockaddr_in& from);
  void answer(std::uint64_t cycle, const sockaddr_in& to);
  void hold();
  void moveJoints();

  Datagram socket_;
  SequenceGate gate_;
  std::vector<JointMotion> joints_;
  std::vector<Reference> references_;
  std::vector<link::JointState> states_;
  std::vector<link::ImuState> imus_;
  std::vector<link::ForceTorqueState> force_torques_;
  Buffer incoming_{};
  Buffer outgoing_{};
  std::uint32_t session_;
  std::uint64_t sequence_ = 0;
  std::uint64_t unreadable_ = 0;
  std::int64_t moved_ns_;
  bool holding_ = true;
  std::uint16_t circuits_ = 0xffff;
};

}  // namespace robotui::rt::hal::udp
