// A plugin without a host: its robot is memory, and does at once what it is told.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "robotui/rt/link/allocations.h"
#include "robotui/rt/plugin/channel.h"
#include "robotui/rt/plugin/control_plugin.h"
#include "robots.h"

namespace robotui::rt::plugins {

#ifdef NDEBUG
constexpr int kLess = 1;
#else
constexpr int kLess = 2;  // of long tests: with sanitizers a cycle takes a hundred times as long
#endif

// A robot with the limits of acceleration that a configuration gives it.
inline RobotPtr withAcceleration(const RobotPtr& robot) {
  if (!robot) return robot;
  auto limited = std::make_shared<config::RobotDescription>(*robot);
  for (auto& joint : limited->joints) joint.acceleration = 20;
  return limited;
}

class FakeRobot final : public RobotInterface {
 public:
  using RobotInterface::RobotInterface;
  bool sense() noexcept override { return true; }
  bool move() noexcept override { return true; }
  link::JointState& state(const std::string& name) {
    return states()[static_cast<std::size_t>(findJoint(name)->index())];
  }
  link::ImuState& imu() { return imuStates()[0]; }
  void take(const std::string& posture) {
    for (const auto& there : description().postures) {
      if (there.name != posture) continue;
      for (const auto& [name, angle] : there.joints) state(name).link_position = angle;
    }
  }
  // References of positions are reached in the same cycle.
  void follow() {
    for (int i = 0; i < getJointNum(); ++i) {
      if ((joint(i).command().mode & link::kPosition) == 0) continue;
      states()[static_cast<std::size_t>(i)].link_position = joint(i).command().position;
    }
  }
};

class FakeLog final : public RtLog {
 public:
  void info(std::string_view /*line*/) noexcept override {}
  void warn(std::string_view /*line*/) noexcept override {}
  void error(std::string_view /*line*/) noexcept override {}
};

class FakeSetup final : public Setup {
 public:
  FakeSetup(RobotPtr of, const std::string& params)
      : described_(std::move(of)), params_(YAML::Load(params)), robot_(described_) {
    robot_.take("home");
  }

  const std::string& name() const override { return name_; }
  const YAML::Node& params() const override { return params_; }
  double period() const override { return 0.001; }
  FakeRobot& robot() override { return robot_; }
  RtLog& log() override { return log_; }
  ChannelDirectory& channels() override { return channels_; }
  std::unique_ptr<ModelInterface> createModel() override { return ModelInterface::create("KDL", described_); }
  const link::MasterSegment& master() override { throw std::logic_error("these plugins have no master"); }
  void claim(const std::vector<std::string>& joints) override { claimed = joints; }
  void fail(const std::string& why) override { failure = why; }

  std::vector<std::string> claimed;
  std::string failure;

 private:
  RobotPtr described_;
  std::string name_ = "plugin";
  YAML::Node params_;
  FakeRobot robot_;
  FakeLog log_;
  std::unique_ptr<ChannelSegment> segment_ = std::make_unique<ChannelSegment>();
  ChannelDirectory channels_{*segment_, {segment_.get()}};
};

// Cycles, of a millisecond unless said otherwise; none may allocate or fail.
inline void run(ControlPlugin& plugin, FakeSetup& setup, int cycles, double period = 0.001) {
  const auto before = link::allocationCount().calls;
  int failures = 0;
  {
    const link::CountAllocations counting;
    for (int i = 0; i < cycles; ++i) {
      failures += plugin.control_loop(period * i, period).isOk() ? 0 : 1;
      setup.robot().follow();
    }
  }
  EXPECT_EQ(link::allocationCount().calls, before) << "allocations in the cycle";
  EXPECT_EQ(failures, 0);
}

}  // namespace robotui::rt::plugins
