// A robot simulated by MuJoCo, in step with the cycle: one period of simulated time for each move.
#pragma once

#include "../simulated_stops.h"
#include "mujoco_pushes.h"
#include "mujoco_world.h"
#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

class MujocoHal final : public Hal {
 public:
  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  Status sense(Measurements& into) noexcept override;
  Status move(std::span<const Reference> references) noexcept override;
  void senseStops(std::span<StopInput> into) noexcept override { stops_.sense(into); }
  void close() noexcept override;
  bool press(std::size_t stop, bool pressed) override { return stops_.press(stop, pressed); }
  std::string push(const link::Push& push) override { return pushes_.take(push, world_, period_); }
  std::vector<std::string> news() override;

 private:
  void command(const MujocoJoint& joint, const Reference& reference) noexcept;
  bool isSound() const noexcept;

  MujocoSettings settings_;
  MujocoWorld world_;
  SimulatedStops stops_;
  MujocoPushes pushes_;
  double period_ = 0;  // s
};

}  // namespace robotui::rt::hal
