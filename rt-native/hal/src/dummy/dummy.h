// A robot that follows its commands and has no weight: XBotCore -D.
#pragma once

#include <vector>

#include "../simulated_stops.h"
#include "joint_motion.h"
#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

// Parameter: `posture`, a group_state of the SRDF to begin in (else zero, or the limit that is nearest to it).
class Dummy : public Hal {
 public:
  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  Status sense(Measurements& into) noexcept override;
  Status move(std::span<const Reference> references) noexcept override;
  void senseStops(std::span<StopInput> into) noexcept override { stops_.sense(into); }
  void close() noexcept override {}
  bool press(std::size_t stop, bool pressed) override { return stops_.press(stop, pressed); }
  std::string push(const link::Push& /*push*/) override {
    return "The kinematic simulation (dummy) knows no forces, so that nothing would give way: take the HAL mujoco.";
  }

 private:
  std::vector<JointMotion> joints_;
  double period_s_ = 0;
  SimulatedStops stops_;
};

// The joints at the beginning, in a named posture or at zero. Throws config::ConfigError where the posture is not
// there.
std::vector<JointMotion> motionsOf(const config::RobotDescription& robot, const std::string& posture,
                                   const config::Place& place);

// A base at rest and sensors that feel nothing but the weight of the IMU.
void measureRest(Measurements& into) noexcept;

}  // namespace robotui::rt::hal
