#include "mujoco_hal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robotui::rt::hal {
namespace {

constexpr double kNano = 1e-9;
constexpr double kVelocityGain = 4;  // of a drive that follows a velocity, times its damping

// MuJoCo would write files and print in the cycle; its data counts warnings anyhow.
void ignoreWarning(const char* /*text*/) {}

template <std::size_t N>
void copy(const mjtNum* from, std::array<double, N>& to) noexcept {
  std::copy_n(from, N, to.begin());
}

}  // namespace

void MujocoHal::open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) {
  mju_user_warning = ignoreWarning;
  settings_ = readMujocoSettings(config, robot, period_ns);
  period_ = static_cast<double>(period_ns) * kNano;
  world_ = buildMujocoWorld(robot, settings_, period_);
}

Status MujocoHal::sense(Measurements& into) noexcept {
  const mjData& data = *world_.data;
  for (std::size_t i = 0; i < world_.joints.size(); ++i) {
    link::JointState& joint = into.joints[i];
    joint.link_position = joint.motor_position = data.qpos[world_.joints[i].position];
    joint.link_velocity = joint.motor_velocity = data.qvel[world_.joints[i].dof];
    joint.effort = data.qfrc_actuator[world_.joints[i].dof];
    joint.temperature_motor = joint.temperature_driver = std::numeric_limits<float>::quiet_NaN();
    joint.fault = 0;
  }
  for (std::size_t i = 0; i < world_.imus.size(); ++i) {
    const mjtNum* at = data.sensordata + world_.imus[i];
    into.imus[i].orientation = {at[1], at[2], at[3], at[0]};
    copy(at + 4, into.imus[i].angular_velocity);
    copy(at + 7, into.imus[i].linear_acceleration);
  }
  for (std::size_t i = 0; i < world_.force_torques.size(); ++i) {
    const mjtNum* at = data.sensordata + world_.force_torques[i];
    // What the part beyond the sensor does to the robot, as sensors say it; MuJoCo says what it is done to.
    for (std::size_t axis = 0; axis < 3; ++axis) into.force_torques[i].force[axis] = -at[axis];
    for (std::size_t axis = 0; axis < 3; ++axis) into.force_torques[i].torque[axis] = -at[3 + axis];
  }
  return isSound() ? Status::kOk : Status::kFault;
}

// force = ctrl - stiffness q - damping q', the form of a drive that MuJoCo can integrate implicitly.
void MujocoHal::command(const MujocoJoint& joint, const Reference& reference) noexcept {
  const auto has = [&](std::uint8_t bits) { return (reference.mode & bits) != 0; };
  double stiffness = 0;
  double damping = 0;
  double ctrl = has(link::kEffort) ? reference.effort : 0;
  if (has(link::kPosition)) {
    stiffness = has(link::kStiffness) ? reference.stiffness : joint.stiffness;
    damping = joint.damping;
    ctrl += stiffness * reference.position;
    // A drive that holds a position integrates: here it knows the load instead.
    if (!has(link::kImpedance)) ctrl += world_.data->qfrc_bias[joint.dof];
  } else if (has(link::kVelocity)) {
    damping = kVelocityGain * joint.damping;
    ctrl += world_.data->qfrc_bias[joint.dof];
  }
  if (has(link::kDamping)) damping = reference.damping;
  if (has(link::kVelocity)) ctrl += damping * reference.velocity;
  mjtNum* bias = world_.model->actuator_biasprm + mjNBIAS * joint.actuator;
  bias[1] = -stiffness;
  bias[2] = -damping;
  world_.data->ctrl[joint.actuator] = ctrl;
}

Status MujocoHal::move(std::span<const Reference> references) noexcept {
  const std::size_t count = std::min(references.size(), world_.joints.size());
  pushes_.begin();
  for (int step = 0; step < settings_.steps; ++step) {
    for (std::size_t i = 0; i < count; ++i) command(world_.joints[i], references[i]);
    pushes_.apply(*world_.model, *world_.data);
    mj_step(world_.model.get(), world_.data.get());
  }
  return isSound() ? Status::kOk : Status::kFault;
}

// A simulation that ran away stays where it is: nothing in it means anything more.
bool MujocoHal::isSound() const noexcept {
  const mjWarningStat* warnings = world_.data->warning;
  return warnings[mjWARN_BADQPOS].number + warnings[mjWARN_BADQVEL].number + warnings[mjWARN_BADQACC].number == 0;
}

// Once.
std::vector<std::string> MujocoHal::news() {
  std::vector<std::string> links;
  std::swap(links, world_.mesh_links);
  if (links.empty() || settings_.ignore_meshes) return {};
  return {"The collision meshes of " + std::to_string(links.size()) + " links (" + links.front() +
          (links.size() > 1 ? ", ..." : "") +
          ") touch nothing in this simulation: it knows boxes, spheres and cylinders."};
}

void MujocoHal::close() noexcept { world_ = {}; }

}  // namespace robotui::rt::hal
