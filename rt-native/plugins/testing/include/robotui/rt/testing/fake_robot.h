// A robot without hardware for tests of plugins: its joints do at once what they are told.
#pragma once

#include <memory>
#include <string>

#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt::testing {

// `joints` revolute joints j1, j2 ... of +-2 rad, 1 rad/s and 10 N m; one chain `arm` of all, and the postures `home`
// (all 0.5) and `zero`. It has no URDF, and so no model.
std::shared_ptr<const config::RobotDescription> fakeDescription(int joints);

class FakeRobot final : public RobotInterface {
 public:
  explicit FakeRobot(std::shared_ptr<const config::RobotDescription> description);
  explicit FakeRobot(int joints) : FakeRobot(fakeDescription(joints)) {}

  bool sense() noexcept override { return true; }

  // What was commanded becomes the state: positions are reached, velocities are integrated, efforts are felt.
  bool move() noexcept override;

  void setPeriod(double seconds) noexcept { period_ = seconds; }
  void put(const std::string& joint, double position);

  // Joints that were commanded in the last move().
  int commanded() const noexcept { return commanded_; }

  link::ImuState& imu(std::size_t i) { return imuStates()[i]; }
  link::ForceTorqueState& forceTorque(std::size_t i) { return forceTorqueStates()[i]; }
  link::JointState& state(int joint) { return states()[static_cast<std::size_t>(joint)]; }

 private:
  double period_ = 0.001;
  int commanded_ = 0;
};

}  // namespace robotui::rt::testing
