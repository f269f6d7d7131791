#include "udp.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::udp {

namespace {

constexpr int kMostPackets = 64;  // read in one cycle: a flood does not keep it
constexpr std::int64_t kGreeting = 2 * link::kSecond;
constexpr int kGreetingMs = 20;

bool isAnswerOf(std::span<const std::byte> packet, Header& into) noexcept {
  return read(packet, into) && into.kind == static_cast<std::uint16_t>(Kind::kState);
}

void checkCounts(const Header& state, const config::RobotDescription& robot, const std::string& peer) {
  const auto differ = [&](std::size_t theirs, std::size_t ours, const char* what) {
    if (theirs == ours) return;
    throw std::runtime_error("The joint controller at " + peer + " has " + std::to_string(theirs) + " " + what +
                             ", the robot '" + robot.name + "' has " + std::to_string(ours) +
                             ": give both the same description.");
  };
  differ(state.joints, robot.joints.size(), "joints");
  differ(state.imus, robot.imus.size(), "IMUs");
  differ(state.force_torques, robot.force_torques.size(), "force-torque sensors");
}

constexpr int kCircuits = 16;

void checkInputs(const std::vector<config::EmergencyStop>& stops) {
  for (const config::EmergencyStop& stop : stops) {
    if (stop.input >= kCircuits)
      throw config::ConfigError(stop.place, "the emergency stop '" + stop.name + "' has the input " +
                                                std::to_string(stop.input) + ", and a packet has those from 0 to 15");
  }
}

}  // namespace

void Udp::open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) {
  const config::Reader params(config.params, config.place.file, "HALInterface.params", config.place);
  params.knowsOnly({"address", "port", "timeout_us"});
  const std::string address = params.textOr("address", "127.0.0.1");
  const auto port = static_cast<std::uint16_t>(params.wholeOr("port", 9870, 1, 65535));
  const std::int64_t timeout =
      params.wholeOr("timeout_us", 5 * period_ns / link::kMicrosecond, 100, 10'000'000) * link::kMicrosecond;
  socket_ = Datagram::connectedTo(addressOf(address, port));
  gate_ = SequenceGate(timeout);
  stops_ = config.emergency_stops;
  checkInputs(stops_);
  session_ = newSession();
  greet(robot, address + ":" + std::to_string(port));
}

// Nobody there is told at once by a refusal of the other computer: then it may still be starting.
void Udp::greet(const config::RobotDescription& robot, const std::string& peer) {
  for (const std::int64_t end = link::now() + kGreeting; link::now() < end;) {
    socket_->send(writeHello(outgoing_, header()));
    socket_->wait(kGreetingMs);
    sockaddr_in from{};
    const auto packet = socket_->receive(incoming_, from);
    if (isAnswerOf(packet, state_)) {
      checkCounts(state_, robot, peer);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(kGreetingMs));
  }
  throw std::runtime_error("No joint controller answers at " + peer +
                           ": start it, or write its address and port into HALInterface.params.");
}

Header Udp::header() noexcept {
  Header header{};
  header.session = session_;
  header.sequence = ++sequence_;
  header.cycle = cycle_;
  return header;
}

// Order is looked at last: what cannot be read must not spoil it.
bool Udp::heard(std::span<const std::byte> packet, Measurements& into) noexcept {
  Header header{};
  if (!isAnswerOf(packet, header) || header.joints != into.joints.size() || header.imus != into.imus.size() ||
      header.force_torques != into.force_torques.size()) {
    ++unreadable_;
    return false;
  }
  SequenceGate admitted = gate_;
  if (!admitted.admit(0, header.session, header.sequence, link::now())) {
    gate_ = admitted;
    return false;
  }
  if (!readState(packet, into)) {
    ++unreadable_;
    return false;
  }
  gate_ = admitted;
  state_ = header;
  return true;
}

// Whoever does not answer is asked: a first cycle has nothing to command yet.
Status Udp::sense(Measurements& into) noexcept {
  sockaddr_in from{};
  for (int i = 0; i < kMostPackets; ++i) {
    const auto packet = socket_->receive(incoming_, from);
    if (packet.empty()) break;
    heard(packet, into);
  }
  if (!gate_.isSilent(link::now())) return Status::kOk;
  socket_->send(writeHello(outgoing_, header()));
  return Status::kTimeout;
}

// Of the last state, as long as that counts.
void Udp::senseStops(std::span<StopInput> into) noexcept {
  if (gate_.isSilent(link::now())) return;
  for (std::size_t i = 0; i < into.size() && i < stops_.size(); ++i)
    into[i] = ((state_.circuits >> stops_[i].input & 1) != 0) == stops_[i].closed ? StopInput::kReleased
                                                                                  : StopInput::kPressed;
}

Status Udp::move(std::span<const Reference> references) noexcept {
  ++cycle_;
  return socket_->send(writeCommand(outgoing_, header(), references)) ? Status::kOk : Status::kTimeout;
}

}  // namespace robotui::rt::hal::udp
