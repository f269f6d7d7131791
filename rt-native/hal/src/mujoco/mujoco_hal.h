// A robot simulated by MuJoCo, in step with the cycle: one period of simulated time for each move.
#pragma once

#include "mujoco_world.h"
#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

class MujocoHal final : public Hal {
 public:
  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  Status sense(Measurements& into) noexcept override;
  Status move(std::span<const Reference> references) noexcept override;
  void close() noexcept override;
  std::vector<std::string> news() override;

 private:
  void command(const MujocoJoint& joint, const Reference& reference) noexcept;
  bool isSound() const noexcept;

  MujocoSettings settings_;
  MujocoWorld world_;
};

}  // namespace robotui::rt::hal
