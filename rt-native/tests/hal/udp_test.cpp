#include "udp/udp.h"

#include <functional>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "rig.h"
#include "robotui/rt/hal/kinds.h"
#include "udp/joint_server.h"

namespace robotui::rt::hal::udp {
namespace {

using namespace std::chrono_literals;

// The simulated joint controller, running.
class Server {
 public:
  Server(const config::RobotDescription& robot, std::uint16_t port)
      : server_(robot, {.address = "127.0.0.1", .port = port, .watchdog_ns = 30 * link::kMillisecond, .posture = ""}),
        thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            server_.wire(circuits_);
            server_.step();
            holds_ = server_.holds();
            refused_ = server_.refused();
          }
        }) {}
  std::uint16_t port() const { return server_.port(); }
  bool holds() const noexcept { return holds_; }
  std::uint64_t refused() const noexcept { return refused_; }
  void wire(std::uint16_t circuits) noexcept { circuits_ = circuits; }

 private:
  JointServer server_;
  std::atomic<std::uint16_t> circuits_{0xffff};
  std::atomic<bool> holds_{true};
  std::atomic<std::uint64_t> refused_{0};
  std::jthread thread_;
};

// Between both: loses a fifth of the packets of each direction, swaps a fifth, adds garbage and copies.
class Relay {
 public:
  explicit Relay(std::uint16_t server)
      : front_(Datagram::boundTo(addressOf("127.0.0.1", 0))),
        back_(Datagram::connectedTo(addressOf("127.0.0.1", server))), thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            front_.wait(1);
            pump();
          }
        }) {}
  std::uint16_t port() const { return front_.port(); }

 private:
  using Bytes = std::vector<std::byte>;

  void pump() {
    sockaddr_in from{};
    for (auto packet = front_.receive(buffer_, from); !packet.empty(); packet = front_.receive(buffer_, from)) {
      client_ = from;
      disturb(Bytes(packet.begin(), packet.end()), to_server_, [this](const Bytes& b) { back_.send(b); });
    }
    sockaddr_in ignored{};
    for (auto packet = back_.receive(buffer_, ignored); !packet.empty(); packet = back_.receive(buffer_, ignored)) {
      disturb(Bytes(packet.begin(), packet.end()), to_client_, [this](const Bytes& b) { front_.sendTo(b, client_); });
    }
  }

  void disturb(Bytes packet, Bytes& kept, const std::function<void(const Bytes&)>& send) {
    const auto dice = random_() % 10;
    if (dice < 2) return;
    if (dice < 4 && kept.empty()) {
      kept = std::move(packet);
      return;
    }
    send(packet);
    if (dice == 4) send(packet);
    if (dice == 5) {
      for (std::byte& byte : packet) byte ^= static_cast<std::byte>(random_());
      send(packet);
    }
    if (dice == 6) send(Bytes(packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(random_() % packet.size())));
    if (!kept.empty()) send(std::exchange(kept, {}));
  }

  Datagram front_;
  Datagram back_;
  Buffer buffer_{};
  Bytes to_server_;
  Bytes to_client_;
  sockaddr_in client_{};
  std::mt19937 random_{5};
  std::jthread thread_;
};

struct UdpTest : testing::Test {
  config::RobotDescription robot = robotOf(3);
  std::array<link::JointState, 3> joints{};
  std::array<Reference, 3> references{};
  Measurements measured{joints, {}, {}};
  Udp hal;
  std::vector<config::EmergencyStop> stops;

  void open(std::uint16_t port, int timeout_us = 30000) {
    config::HalConfig config;
    config.emergency_stops = stops;
    config.params = YAML::Load("{port: " + std::to_string(port) + ", timeout_us: " + std::to_string(timeout_us) + "}");
    hal.open(robot, config, link::kMillisecond);
  }

  Status cycle() {
    const Status status = hal.sense(measured);
    hal.move(references);
    std::this_thread::sleep_for(1ms);
    return status;
  }

  bool cycleUntil(const std::function<bool()>& condition) {
    for (const std::int64_t end = link::now() + 10 * link::kSecond; link::now() < end;) {
      cycle();
      if (condition()) return true;
    }
    return false;
  }
};

TEST_F(UdpTest, joints_of_another_process_follow) {
  const Server server(robot, 0);
  open(server.port());
  references.fill({0.2, 0, 0, 0, 0, link::kPosition});
  EXPECT_TRUE(cycleUntil([&] { return std::abs(joints[2].link_position - 0.2) < 1e-9; }));
  EXPECT_FALSE(server.holds());
}

TEST_F(UdpTest, nobody_there_is_an_error_that_names_the_place) {
  std::uint16_t free_port = 0;
  { free_port = Datagram::boundTo(addressOf("127.0.0.1", 0)).port(); }
  try {
    open(free_port);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("127.0.0.1:" + std::to_string(free_port)), std::string::npos)
        << error.what();
  }
}

TEST_F(UdpTest, another_number_of_joints_is_an_error) {
  const Server server(robotOf(5), 0);
  EXPECT_THROW(open(server.port()), std::runtime_error);
}

TEST_F(UdpTest, lost_swapped_doubled_and_broken_packets_do_not_stop_the_motion) {
  const Server server(robot, 0);
  const Relay relay(server.port());
  open(relay.port(), 200'000);
  references.fill({0.3, 0, 0, 0, 0, link::kPosition});
  double last = 0;
  bool backwards = false;
  EXPECT_TRUE(cycleUntil([&] {
    backwards = backwards || joints[0].link_position < last - 1e-12;
    last = joints[0].link_position;
    return std::abs(last - 0.3) < 1e-9;
  }));
  EXPECT_FALSE(backwards);  // a late state was never taken for a new one
  EXPECT_TRUE(cycleUntil([&] { return hal.refused() > 10 && hal.lost() > 10 && server.refused() > 10; }));
}

TEST_F(UdpTest, the_counterpart_holds_by_itself_when_commands_end) {
  const Server server(robot, 0);
  open(server.port());
  references.fill({0, 0.5, 0, 0, 0, link::kVelocity});
  EXPECT_TRUE(cycleUntil([&] { return joints[0].link_velocity > 0.4; }));
  for (int i = 0; i < 2000 && !server.holds(); ++i) std::this_thread::sleep_for(1ms);
  ASSERT_TRUE(server.holds());
  const auto rest = [&] { return hal.sense(measured) == Status::kOk && joints[0].link_velocity == 0; };
  bool at_rest = false;
  for (int i = 0; i < 2000 && !at_rest; ++i) {
    at_rest = rest();  // asks by hello, commands nothing
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_TRUE(at_rest);
}

TEST_F(UdpTest, a_counterpart_that_dies_is_a_time_out_and_one_that_returns_is_found) {
  auto server = std::make_unique<Server>(robot, std::uint16_t{0});
  const std::uint16_t port = server->port();
  open(port);
  EXPECT_TRUE(cycleUntil([&] { return cycle() == Status::kOk; }));
  server.reset();
  EXPECT_TRUE(cycleUntil([&] { return cycle() == Status::kTimeout; }));
  server = std::make_unique<Server>(robot, port);
  EXPECT_TRUE(cycleUntil([&] { return cycle() == Status::kOk; }));
}

TEST_F(UdpTest, emergency_stops_are_circuits_that_are_closed_unless_they_are_said_to_be_open) {
  stops = {{"door", "", 0, true, {}}, {"mat", "", 3, false, {}}};
  auto server = std::make_unique<Server>(robot, std::uint16_t{0});
  server->wire(1);
  open(server->port());
  std::array<StopInput, 2> said{};
  const auto say = [&](StopInput door, StopInput mat) {
    return cycleUntil([&] {
      said.fill(StopInput::kUnread);
      hal.senseStops(said);
      return said[0] == door && said[1] == mat;
    });
  };
  EXPECT_TRUE(say(StopInput::kReleased, StopInput::kReleased));
  server->wire(8);
  EXPECT_TRUE(say(StopInput::kPressed, StopInput::kPressed));
  server.reset();
  EXPECT_TRUE(say(StopInput::kUnread, StopInput::kUnread));
}

TEST_F(UdpTest, wrong_parameters_are_named) {
  config::HalConfig config;
  config.params = YAML::Load("{adress: 127.0.0.1}");
  EXPECT_THROW(hal.open(robot, config, link::kMillisecond), config::ConfigError);
  config.params = YAML::Load("{address: somewhere}");
  EXPECT_THROW(hal.open(robot, config, link::kMillisecond), std::runtime_error);
}

}  // namespace
}  // namespace robotui::rt::hal::udp
