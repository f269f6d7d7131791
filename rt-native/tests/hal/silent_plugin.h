// A robot whose joints are all in effort mode when its plugin falls silent.
#pragma once

#include <cmath>

#include "rig.h"
#include "robots.h"

namespace robotui::rt::hal {

class SilentPlugin {
 public:
  static constexpr std::int64_t kPeriod = link::kMillisecond;

  // All outlive it; `hardware` is open, in the posture in which it begins.
  SilentPlugin(RobotPtr robot, Hal& hardware, SafeTorque& law)
      : robot_(std::move(robot)), joints_(static_cast<std::uint32_t>(robot_->joints.size())),
        inbox_(CommandPlan{{{0, 0, 1}}, {0}, 1000}, joints_, 2, time_),
        cycle_(*robot_, {.period_ns = kPeriod, .deadline = 0.8, .safe_damping = 5, .misses_before_safe = 2}, hardware,
               *board_, inbox_, law, *state_) {
    inbox_.offer(0, CommandInbox::HostView::open(host_.shareReadOnly()));
    run(1);
    for (std::uint32_t j = 0; j < joints_; ++j) grants_.grant(j, 0);
    command(1);
    run(5);
  }

  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      cycle_.run(++number_, time_.now);
      time_.passTo(time_.now + kPeriod);
    }
  }

  link::FrameData frame() const {
    link::FrameData data{};
    link::StateReader(*state_).newest(data);
    return data;
  }

  // The greatest of all joints.
  double mostEffort() const {
    const link::FrameData data = frame();
    double most = 0;
    for (std::uint32_t j = 0; j < joints_; ++j) most = std::max(most, std::abs(data.joints[j].effort_reference));
    return most;
  }
  double movedFrom(const link::FrameData& before) const {
    const link::FrameData data = frame();
    double most = 0;
    for (std::uint32_t j = 0; j < joints_; ++j)
      most = std::max(most, std::abs(data.joints[j].link_position - before.joints[j].link_position));
    return most;
  }

  bool isSafe() const {
    const link::FrameData data = frame();
    return std::all_of(data.joints.begin(), data.joints.begin() + joints_, [](const link::JointState& joint) {
      return joint.control == static_cast<std::uint8_t>(link::Control::kSafe);
    });
  }

 private:
  // The last that is heard of it: no effort at all.
  void command(std::uint64_t ahead) {
    link::CommandData data{};
    data.cycle = number_ + ahead;
    data.joints.fill(effort(0));
    link::SlotWriter(*host_, 0, joints_).write(data);
  }

  RobotPtr robot_;
  std::uint32_t joints_;
  FakeTime time_;
  link::Segment<link::StateSegment> state_ = link::Segment<link::StateSegment>::create(1);
  link::Segment<link::BoardSegment> board_ = link::Segment<link::BoardSegment>::create(1);
  link::Segment<link::HostSegment> host_ = link::Segment<link::HostSegment>::create(1);
  link::BoardWriter grants_{*board_};
  CommandInbox inbox_;
  Cycle cycle_;
  std::uint64_t number_ = 0;
};

}  // namespace robotui::rt::hal
