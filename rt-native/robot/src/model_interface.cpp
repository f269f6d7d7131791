#include "robotui/rt/robot/model_interface.h"

#include <algorithm>
#include <stdexcept>

#include "joint_vectors.h"
#include "kdl_model.h"
#include "robotui/rt/link/words.h"
#ifdef RT_HAVE_MUJOCO
#include "mujoco_model.h"
#endif

namespace robotui::rt {
namespace {

int indexOf(const XBotInterface& in, const std::string& name) noexcept {
  for (int i = 0; i < in.getJointNum(); ++i) {
    if (in.joint(i).name() == name) return i;
  }
  return -1;
}

void copyState(const Joint& from, link::JointState& to) noexcept {
  to.link_position = from.getJointPosition();
  to.motor_position = from.getMotorPosition();
  to.link_velocity = from.getJointVelocity();
  to.motor_velocity = from.getMotorVelocity();
  to.effort = from.getJointEffort();
}

[[noreturn]] void refuse(std::string_view type) {
  const std::string hint = type == "MUJOCO" ? "; MuJoCo was not found when this was built" : "";
  throw std::runtime_error("there is no model of the type '" + std::string(type) + "'; there are " +
                           link::listed(ModelInterface::types()) + hint);
}

}  // namespace

std::vector<std::string> ModelInterface::types() {
#ifdef RT_HAVE_MUJOCO
  return {"KDL", "MUJOCO"};
#else
  return {"KDL"};
#endif
}

std::unique_ptr<ModelInterface> ModelInterface::create(std::string_view type,
                                                       std::shared_ptr<const config::RobotDescription> robot) {
  if (type == "KDL") return std::make_unique<KdlModel>(std::move(robot));
#ifdef RT_HAVE_MUJOCO
  if (type == "MUJOCO") return std::make_unique<MujocoModel>(std::move(robot));
#endif
  refuse(type);
}

void ModelInterface::setJointPosition(const Eigen::Ref<const Eigen::VectorXd>& q) noexcept {
  auto all = states();
  scatter(all, q, [](link::JointState& s, double v) { s.link_position = s.motor_position = v; });
}

void ModelInterface::setJointVelocity(const Eigen::Ref<const Eigen::VectorXd>& qdot) noexcept {
  auto all = states();
  scatter(all, qdot, [](link::JointState& s, double v) { s.link_velocity = s.motor_velocity = v; });
}

void ModelInterface::setJointEffort(const Eigen::Ref<const Eigen::VectorXd>& tau) noexcept {
  auto all = states();
  scatter(all, tau, [](link::JointState& s, double v) { s.effort = v; });
}

void ModelInterface::pair(const XBotInterface& other) {
  pairs_.clear();
  for (int i = 0; i < getJointNum(); ++i) {
    const int there = indexOf(other, joint(i).name());
    if (there >= 0) pairs_.emplace_back(i, there);
  }
  paired_ = &other;
}

void ModelInterface::syncFrom(const XBotInterface& other) noexcept {
  const auto mine = states();
  if (paired_ == &other) {
    for (const auto& [own, there] : pairs_) copyState(other.joint(there), mine[static_cast<std::size_t>(own)]);
  } else {
    for (int i = 0; i < getJointNum(); ++i) {
      const int there = indexOf(other, joint(i).name());
      if (there >= 0) copyState(other.joint(there), mine[static_cast<std::size_t>(i)]);
    }
  }
  update();
}

void ModelInterface::syncTo(XBotInterface& other) const noexcept {
  const auto copy = [](const Joint& from, Joint& to) {
    if ((from.command().mode & link::kPosition) != 0) to.setPositionReference(from.command().position);
  };
  if (paired_ == &other) {
    for (const auto& [own, there] : pairs_) copy(joint(own), other.joint(there));
    return;
  }
  for (int i = 0; i < getJointNum(); ++i) {
    const int there = indexOf(other, joint(i).name());
    if (there >= 0) copy(joint(i), other.joint(there));
  }
}

}  // namespace robotui::rt
