// The effort of joints in effort mode that nobody commands.
#pragma once

#include <memory>
#include <span>

#include "robotui/rt/config/config.h"
#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

class SafeTorque {
 public:
  virtual ~SafeTorque() = default;
  // One effort a joint, on the real-time thread. It may be no number: then damping alone is used.
  virtual void compute(const Measurements& measured, std::span<double> effort) noexcept = 0;
};

// Nothing but the damping that the cycle adds in any case.
class NoTorque : public SafeTorque {
 public:
  void compute(const Measurements& measured, std::span<double> effort) noexcept override;
};

// Carries the robot's own weight. Throws std::runtime_error where the model cannot be made.
std::unique_ptr<SafeTorque> makeGravityTorque(const std::shared_ptr<const config::RobotDescription>& robot,
                                              const std::string& model_type);

}  // namespace robotui::rt::hal
