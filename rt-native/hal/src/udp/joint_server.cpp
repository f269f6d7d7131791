#include "joint_server.h"

#include <algorithm>

#include "../dummy/dummy.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::udp {

namespace {

constexpr double kLongestStep = 0.1;  // s: a program that was halted does not jump

std::uint64_t keyOf(const sockaddr_in& address) noexcept {
  return (std::uint64_t{address.sin_addr.s_addr} << 16) | address.sin_port;
}

}  // namespace

JointServer::JointServer(const config::RobotDescription& robot, const JointServerSettings& settings)
    : socket_(Datagram::boundTo(addressOf(settings.address, settings.port))), gate_(settings.watchdog_ns),
      joints_(motionsOf(robot, settings.posture, {})), references_(robot.joints.size()), states_(robot.joints.size()),
      imus_(robot.imus.size()), force_torques_(robot.force_torques.size()), session_(newSession()),
      moved_ns_(link::now()) {
  hold();
}

// Where it stands: a velocity ends, an effort gives way to holding.
void JointServer::hold() {
  holding_ = true;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    references_[j] = {joints_[j].position(), 0, 0, 0, 0, link::kPosition};
}

void JointServer::moveJoints() {
  const std::int64_t now = link::now();
  const double seconds = std::min(static_cast<double>(now - moved_ns_) * 1e-9, kLongestStep);
  moved_ns_ = now;
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].step(references_[j], seconds);
}

void JointServer::obey(std::span<const std::byte> packet, const Header& header, const sockaddr_in& from) {
  SequenceGate admitted = gate_;
  if (!admitted.admit(keyOf(from), header.session, header.sequence, link::now())) {
    gate_ = admitted;
    return;
  }
  if (!readReferences(packet, references_)) {
    ++unreadable_;
    return;
  }
  gate_ = admitted;
  holding_ = false;
  answer(header.cycle, from);
}

void JointServer::heard(std::span<const std::byte> packet, const sockaddr_in& from) {
  Header header{};
  if (!read(packet, header)) {
    ++unreadable_;
  } else if (header.kind == static_cast<std::uint16_t>(Kind::kHello)) {
    answer(header.cycle, from);
  } else if (header.kind == static_cast<std::uint16_t>(Kind::kCommand)) {
    obey(packet, header, from);
  }
}

void JointServer::answer(std::uint64_t cycle, const sockaddr_in& to) {
  Measurements measured{states_, imus_, force_torques_};
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].measure(states_[j]);
  measureRest(measured);
  Header header{};
  header.session = session_;
  header.sequence = ++sequence_;
  header.cycle = cycle;
  header.circuits = circuits_;
  socket_.sendTo(writeState(outgoing_, header, measured), to);
}

void JointServer::step() {
  socket_.wait(1);
  moveJoints();
  sockaddr_in from{};
  for (auto packet = socket_.receive(incoming_, from); !packet.empty(); packet = socket_.receive(incoming_, from))
    heard(packet, from);
  if (!holding_ && gate_.isSilent(link::now())) hold();
}

}  // namespace robotui::rt::hal::udp
