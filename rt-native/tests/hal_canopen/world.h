// Simulated drives on a bus of their own, and the HAL that leads them.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "canopen/canopen.h"
#include "canopen/simulated/simulated_bus.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::canopen {

constexpr double kCounts = 10'000;  // per rad

inline config::RobotDescription robotOf(int joints) {
  config::RobotDescription robot{};
  robot.name = "test";
  for (int i = 0; i < joints; ++i)
    robot.joints.push_back(
        {i + 1, "joint_" + std::to_string(i + 1), config::JointType::kRevolute, -2.0, 2.0, 1.0, 50.0});
  return robot;
}

// The bus runs on a thread of its own; what a test does to it, it does in between.
class World {
 public:
  explicit World(int drives) : path_(makePath()), bus_("unix:" + path_) {
    for (int i = 0; i < drives; ++i) bus_.add(static_cast<std::uint8_t>(i + 1), 1000.0 * (i + 1));
    thread_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        while (waiting_) std::this_thread::yield();
        const std::lock_guard lock(mutex_);
        bus_.step(1);
      }
    });
  }
  ~World() {
    thread_.request_stop();
    thread_.join();
  }
  std::string interface() const { return "unix:" + path_; }

  template <typename Do>
  auto with(Do&& act) {
    waiting_ = true;
    const std::lock_guard lock(mutex_);
    waiting_ = false;
    return act(bus_);
  }
  template <typename Do>
  auto with(std::size_t drive, Do&& act) {
    return with([&](simulated::SimulatedBus& bus) { return act(bus.drive(drive)); });
  }

 private:
  static std::string makePath() {
    static int count = 0;
    return testing::TempDir() + "can-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
  }
  std::string path_;
  std::mutex mutex_;
  std::atomic<bool> waiting_{false};
  simulated::SimulatedBus bus_;
  std::jthread thread_;
};

struct CanOpenTest : testing::Test {
  config::RobotDescription robot = robotOf(2);
  World world{2};
  std::vector<link::JointState> joints{2};
  std::vector<Reference> references{2};
  Measurements measured{joints, {}, {}};
  CanOpen hal;
  bool is_open = false;
  bool is_sensed = false;
  std::vector<std::string> told;
  std::vector<config::EmergencyStop> stops;

  // Patient: machines that test are late. `more` are parameters, with a comma in front.
  void open(const std::string& more = "", const std::string& drive = "") {
    config::HalConfig config;
    config.emergency_stops = stops;
    std::string drives;
    for (int i = 1; i <= 2; ++i)
      drives += "joint_" + std::to_string(i) + ": {node: " + std::to_string(i) +
                ", counts_per_radian: " + std::to_string(i == 1 ? kCounts : -kCounts) + drive + "}, ";
    const std::string patient = more.find("missed_pdos") == std::string::npos ? ", missed_pdos: 1000" : "";
    const std::string heart =
        more.find("heartbeat") == std::string::npos ? ", heartbeat_ms: 100, heartbeat_timeout_ms: 20000" : "";
    config.params =
        YAML::Load("{interface: '" + world.interface() + "', drives: {" + drives + "}" + patient + heart + more + "}");
    hal.open(robot, config, 2 * link::kMillisecond);
    is_open = true;
  }
  void TearDown() override {
    if (is_open) hal.close();
  }

  // As a cycle of the control does it.
  Status cycle() {
    const Status status = hal.sense(measured);
    if (status == Status::kOk && !is_sensed) {
      is_sensed = true;
      for (std::size_t j = 0; j < joints.size(); ++j)
        references[j] = {joints[j].link_position, 0, 0, 0, 0, link::kPosition};
    }
    if (is_sensed) hal.move(references);
    for (std::string& sentence : hal.news()) told.push_back(std::move(sentence));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return status;
  }

  bool cycleUntil(const std::function<bool()>& condition) {
    for (const std::int64_t end = link::now() + 20 * link::kSecond; link::now() < end;) {
      cycle();
      if (condition()) return true;
    }
    return false;
  }
  bool cycleUntil(Status status) {
    for (const std::int64_t end = link::now() + 20 * link::kSecond; link::now() < end;)
      if (cycle() == status) return true;
    return false;
  }
  bool isTold(const std::string& words) const {
    return std::any_of(told.begin(), told.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }
  // Of the drive of joint_1, "fault: 0x3210 (DC link over-voltage)".
  bool stands(DrivePhase phase, const std::string& detail) {
    const DriveReport report = hal.drives().front();
    return report.joint == "joint_1" && report.phase == phase && report.detail == detail;
  }
  std::string all() const {
    std::string text;
    for (const std::string& line : told) text += line + "\n";
    return text;
  }
};

}  // namespace robotui::rt::hal::canopen
