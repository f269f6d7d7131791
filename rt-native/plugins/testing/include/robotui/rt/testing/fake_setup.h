// What a plugin is given in a test, and a bench that takes it through its life as a host does.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robotui/rt/link/segment.h"
#include "robotui/rt/plugin/io_plugin.h"
#include "robotui/rt/testing/fake_robot.h"

namespace robotui::rt::testing {

class FakeLog final : public RtLog {
 public:
  void info(std::string_view line) noexcept override { lines_.emplace_back(line); }
  void warn(std::string_view line) noexcept override { lines_.emplace_back(line); }
  void error(std::string_view line) noexcept override { lines_.emplace_back(line); }
  const std::vector<std::string>& lines() const noexcept { return lines_; }

 private:
  std::vector<std::string> lines_;
};

class FakeSetup final : public Setup {
 public:
  // `params` as YAML. Of the model type `model_type` where the robot's description has a URDF.
  FakeSetup(FakeRobot& robot, const std::string& params, double period = 0.001, std::string model_type = "KDL");

  const std::string& name() const override { return name_; }
  const YAML::Node& params() const override { return params_; }
  double period() const override { return period_; }
  RobotInterface& robot() override { return robot_; }
  RtLog& log() override { return log_; }
  ChannelDirectory& channels() override { return channels_; }
  std::unique_ptr<ModelInterface> createModel() override;
  const link::MasterSegment& master() override { return *master_; }
  void claim(const std::vector<std::string>& joints) override {
    claims_.insert(claims_.end(), joints.begin(), joints.end());
  }
  void fail(const std::string& why) override { failure_ = why; }

  FakeRobot& fake() noexcept { return robot_; }
  const FakeLog& lines() const noexcept { return log_; }
  const std::vector<std::string>& claims() const noexcept { return claims_; }
  const std::string& failure() const noexcept { return failure_; }
  link::MasterSegment& masterSegment() noexcept { return *master_; }

 private:
  std::string name_ = "test";
  YAML::Node params_;
  double period_;
  std::string model_type_;
  FakeRobot& robot_;
  FakeLog log_;
  std::unique_ptr<ChannelSegment> segment_;
  ChannelDirectory channels_;
  std::unique_ptr<link::MasterSegment> master_;
  std::vector<std::string> claims_;
  std::string failure_;
};

// Init, start, any number of cycles (sense, control_loop, move), stop, close.
class PluginBench {
 public:
  PluginBench(ControlPlugin& plugin, FakeSetup& setup) : plugin_(plugin), setup_(setup) {}

  bool init() { return plugin_.init_control_plugin(setup_); }
  void start() { note(plugin_.on_start(time_)); }
  void cycles(int count);
  void run(double seconds) { cycles(static_cast<int>(seconds / setup_.period())); }
  void stop() { plugin_.on_stop(time_); }
  void close() { plugin_.close(); }
  double time() const noexcept { return time_; }

  // What on_start or control_loop said last when it failed; empty where none did.
  std::string_view failure() const noexcept { return failure_.view(); }

  // What the cycles asked of the heap; only counted in programs that link rt::malloc_counter.
  std::uint64_t allocations() const noexcept { return allocations_; }

 private:
  void note(const RtStatus& status) noexcept {
    if (!status.isOk()) failure_.assign(status.text());
  }

  ControlPlugin& plugin_;
  FakeSetup& setup_;
  double time_ = 100;
  link::FixedText<RtStatus::kTextLength> failure_;
  std::uint64_t allocations_ = 0;
};

}  // namespace robotui::rt::testing
