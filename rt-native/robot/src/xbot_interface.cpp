#include "robotui/rt/robot/xbot_interface.h"

#include <algorithm>

#include "joint_vectors.h"

namespace robotui::rt {

XBotInterface::XBotInterface(std::shared_ptr<const config::RobotDescription> description)
    : description_(std::move(description)), states_(description_->joints.size()),
      commands_(description_->joints.size()), imu_states_(description_->imus.size()),
      force_torque_states_(description_->force_torques.size()) {
  joints_.reserve(description_->joints.size());  // chains point to them
  for (std::size_t i = 0; i < description_->joints.size(); ++i) {
    joints_.emplace_back(description_->joints[i], static_cast<int>(i), states_[i], commands_[i]);
  }
  for (const auto& chain : description_->chains) {
    std::vector<Joint*> members;
    for (const auto& name : chain.joints) members.push_back(findJoint(name));
    std::erase(members, nullptr);
    chains_.emplace_back(chain, std::move(members));
  }
  for (std::size_t i = 0; i < imu_states_.size(); ++i) {
    imu_states_[i].orientation = {0, 0, 0, 1};
    imus_.push_back({description_->imus[i].name, description_->imus[i].link, &imu_states_[i]});
  }
  for (std::size_t i = 0; i < force_torque_states_.size(); ++i) {
    const auto& sensor = description_->force_torques[i];
    force_torques_.push_back({sensor.name, sensor.link, &force_torque_states_[i]});
  }
}

const config::RobotDescription& XBotInterface::description() const noexcept { return *description_; }
int XBotInterface::getJointNum() const noexcept { return static_cast<int>(joints_.size()); }
Joint& XBotInterface::joint(int index) noexcept { return joints_[static_cast<std::size_t>(index)]; }
const Joint& XBotInterface::joint(int index) const noexcept { return joints_[static_cast<std::size_t>(index)]; }

Joint* XBotInterface::findJoint(std::string_view name) noexcept {
  const auto found =
      std::find_if(joints_.begin(), joints_.end(), [name](const Joint& joint) { return joint.name() == name; });
  return found == joints_.end() ? nullptr : &*found;
}

Joint* XBotInterface::findJoint(int id) noexcept {
  const auto found =
      std::find_if(joints_.begin(), joints_.end(), [id](const Joint& joint) { return joint.id() == id; });
  return found == joints_.end() ? nullptr : &*found;
}

KinematicChain* XBotInterface::findChain(std::string_view name) noexcept {
  const auto found = std::find_if(chains_.begin(), chains_.end(),
                                  [name](const KinematicChain& chain) { return chain.name() == name; });
  return found == chains_.end() ? nullptr : &*found;
}

std::span<KinematicChain> XBotInterface::chains() noexcept { return chains_; }
std::span<const Imu> XBotInterface::imus() const noexcept { return imus_; }
std::span<const ForceTorque> XBotInterface::forceTorques() const noexcept { return force_torques_; }

void XBotInterface::getJointPosition(Eigen::Ref<Eigen::VectorXd> q) const noexcept {
  gather(states_, q, [](const link::JointState& s) { return s.link_position; });
}
void XBotInterface::getMotorPosition(Eigen::Ref<Eigen::VectorXd> q) const noexcept {
  gather(states_, q, [](const link::JointState& s) { return s.motor_position; });
}
void XBotInterface::getJointVelocity(Eigen::Ref<Eigen::VectorXd> qdot) const noexcept {
  gather(states_, qdot, [](const link::JointState& s) { return s.link_velocity; });
}
void XBotInterface::getMotorVelocity(Eigen::Ref<Eigen::VectorXd> qdot) const noexcept {
  gather(states_, qdot, [](const link::JointState& s) { return s.motor_velocity; });
}
void XBotInterface::getJointEffort(Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  gather(states_, tau, [](const link::JointState& s) { return s.effort; });
}
void XBotInterface::getPositionReference(Eigen::Ref<Eigen::VectorXd> q) const noexcept {
  gather(states_, q, [](const link::JointState& s) { return s.position_reference; });
}
void XBotInterface::setPositionReference(const Eigen::Ref<const Eigen::VectorXd>& q) noexcept {
  scatter(joints_, q, [](Joint& j, double v) { j.setPositionReference(v); });
}
void XBotInterface::setVelocityReference(const Eigen::Ref<const Eigen::VectorXd>& qdot) noexcept {
  scatter(joints_, qdot, [](Joint& j, double v) { j.setVelocityReference(v); });
}
void XBotInterface::setEffortReference(const Eigen::Ref<const Eigen::VectorXd>& tau) noexcept {
  scatter(joints_, tau, [](Joint& j, double v) { j.setEffortReference(v); });
}
void XBotInterface::setStiffness(const Eigen::Ref<const Eigen::VectorXd>& k) noexcept {
  scatter(joints_, k, [](Joint& j, double v) { j.setStiffness(v); });
}
void XBotInterface::setDamping(const Eigen::Ref<const Eigen::VectorXd>& d) noexcept {
  scatter(joints_, d, [](Joint& j, double v) { j.setDamping(v); });
}

std::span<link::JointState> XBotInterface::states() noexcept { return states_; }
std::span<link::JointCommand> XBotInterface::commands() noexcept { return commands_; }
std::span<link::ImuState> XBotInterface::imuStates() noexcept { return imu_states_; }
std::span<link::ForceTorqueState> XBotInterface::forceTorqueStates() noexcept { return force_torque_states_; }

}  // namespace robotui::rt
