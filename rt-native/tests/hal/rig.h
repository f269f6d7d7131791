// A HAL's cycle with everything around it, in one process and in one thread.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "cycle.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/command.h"

namespace robotui::rt::hal {

inline config::RobotDescription robotOf(int joints) {
  config::RobotDescription robot{};
  robot.name = "test";
  for (int i = 0; i < joints; ++i) {
    robot.joints.push_back(
        {i + 1, "joint_" + std::to_string(i + 1), config::JointType::kRevolute, -2.0, 2.0, 1.0, 50.0});
  }
  return robot;
}

// A robot that is where it was put, and remembers what it was told.
class FakeHal : public Hal {
 public:
  void open(const config::RobotDescription& /*robot*/, const config::HalConfig& /*config*/,
            std::int64_t /*period_ns*/) override {}
  Status sense(Measurements& into) noexcept override {
    if (status != Status::kOk) return status;
    for (link::JointState& joint : into.joints) {
      joint.link_position = joint.motor_position = position;
      joint.link_velocity = joint.motor_velocity = velocity;
    }
    return Status::kOk;
  }
  Status move(std::span<const Reference> references) noexcept override {
    sent.assign(references.begin(), references.end());
    ++moves;
    return Status::kOk;
  }
  void senseStops(std::span<StopInput> into) noexcept override {
    std::copy_n(stops.begin(), std::min(stops.size(), into.size()), into.begin());
  }
  void close() noexcept override {}

  Status status = Status::kOk;
  double position = 0;
  double velocity = 0;
  std::vector<StopInput> stops;
  std::vector<Reference> sent;
  int moves = 0;
};

class FakeTorque : public SafeTorque {
 public:
  void compute(const Measurements& /*measured*/, std::span<double> effort) noexcept override {
    std::fill(effort.begin(), effort.end(), value);
  }
  double value = 7;
};

// Time that passes only here: what is to happen happens when its time has come, however long the machine takes for it.
class FakeTime : public Waiting {
 public:
  std::int64_t now = 0;

  void at(std::int64_t ns, std::function<void()> what) { events_.emplace(ns, std::move(what)); }

  void passTo(std::int64_t ns) {
    while (!events_.empty() && events_.begin()->first <= ns) happen();
    now = std::max(now, ns);
  }
  bool isOver(std::int64_t deadline_ns) const noexcept override { return now >= deadline_ns; }
  bool await(const link::SlotReader& slot, std::int64_t deadline_ns) noexcept override {
    if (!events_.empty() && events_.begin()->first < deadline_ns)
      happen();
    else
      passTo(deadline_ns);
    return slot.hasNew();
  }

 private:
  void happen() {
    const auto event = events_.extract(events_.begin());
    now = std::max(now, event.key());
    event.mapped()();
  }
  std::multimap<std::int64_t, std::function<void()>> events_;
};

// Plugin 0 runs in every cycle, plugin 1 in every tenth, both in host 0; plugin 2 runs in every cycle in host 1.
struct Rig {
  static constexpr int kJoints = 3;
  static constexpr std::uint64_t kStartCycles = 50;
  config::RobotDescription robot = robotOf(kJoints);
  link::Segment<link::StateSegment> state = link::Segment<link::StateSegment>::create(1);
  link::Segment<link::BoardSegment> board = link::Segment<link::BoardSegment>::create(1);
  link::Segment<link::HostSegment> host = link::Segment<link::HostSegment>::create(1);
  link::Segment<link::HostSegment> second_host = link::Segment<link::HostSegment>::create(1);
  link::BoardWriter grants{*board};
  FakeHal hardware;
  FakeTorque torque;
  FakeTime time;
  CommandInbox inbox;
  CycleSettings settings{.period_ns = link::kMillisecond, .deadline = 0.8, .safe_damping = 2, .misses_before_safe = 2};
  std::optional<Cycle> cycle;
  std::uint64_t number = 0;

  // In the test's own time, or waiting as another one does.
  explicit Rig(Waiting* other = nullptr)
      : inbox(CommandPlan{{{0, 0, 1}, {0, 1, 10}, {1, 0, 1}}, {0, 1, 2}, kStartCycles}, kJoints, 2,
              other == nullptr ? static_cast<Waiting&>(time) : *other) {
    inbox.offer(0, CommandInbox::HostView::open(host.shareReadOnly()));
    inbox.offer(1, CommandInbox::HostView::open(second_host.shareReadOnly()));
    cycle.emplace(robot, settings, hardware, *board, inbox, torque, *state);
  }

  void run() {
    const std::int64_t start = time.now;
    time.passTo(start);
    cycle->run(++number, start);
    time.passTo(start + settings.period_ns);
  }

  // All joints as this one; an answer to the cycle that comes, as a plugin's would be to one that has begun.
  void command(const link::JointCommand& command, std::uint16_t plugin = 0) { answer(number + 1, command, plugin); }

  void answer(std::uint64_t to, link::JointCommand command, std::uint16_t plugin = 0) {
    link::CommandData data{};
    data.cycle = to;
    command.plugin = plugin;
    data.joints.fill(command);
    link::SlotWriter(plugin == 2 ? *second_host : *host, plugin == 1 ? 1 : 0, kJoints).write(data);
  }

  void grantAll(std::uint16_t plugin = 0) {
    for (std::uint32_t j = 0; j < kJoints; ++j) grants.grant(j, plugin);
  }

  // What a plugin would see: the frame of the next cycle.
  link::FrameData frame() const {
    link::FrameData data{};
    link::StateReader(*state).newest(data);
    return data;
  }

  link::Control control() {
    run();
    return static_cast<link::Control>(frame().joints[0].control);
  }
};

inline link::JointCommand commandOf(link::Mode mode, double value) {
  link::JointCommand command{};
  command.mode = mode;
  (mode == link::kPosition ? command.position : mode == link::kVelocity ? command.velocity : command.effort) = value;
  return command;
}

inline link::JointCommand position(double value) { return commandOf(link::kPosition, value); }
inline link::JointCommand velocity(double value) { return commandOf(link::kVelocity, value); }
inline link::JointCommand effort(double value) { return commandOf(link::kEffort, value); }

}  // namespace robotui::rt::hal
