#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt {
namespace {

Eigen::Vector3d vector(const std::array<double, 3>& v) noexcept { return {v[0], v[1], v[2]}; }

}  // namespace

Eigen::Quaterniond Imu::orientation() const noexcept {
  const auto& q = state->orientation;
  return {q[3], q[0], q[1], q[2]};
}
Eigen::Vector3d Imu::angularVelocity() const noexcept { return vector(state->angular_velocity); }
Eigen::Vector3d Imu::linearAcceleration() const noexcept { return vector(state->linear_acceleration); }
Eigen::Vector3d ForceTorque::force() const noexcept { return vector(state->force); }
Eigen::Vector3d ForceTorque::torque() const noexcept { return vector(state->torque); }

}  // namespace robotui::rt
