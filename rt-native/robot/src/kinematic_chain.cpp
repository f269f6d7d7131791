#include "joint_vectors.h"
#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt {

KinematicChain::KinematicChain(const config::ChainDescription& description, std::vector<Joint*> joints)
    : description_(&description), joints_(std::move(joints)) {}

const std::string& KinematicChain::name() const noexcept { return description_->name; }
const std::string& KinematicChain::baseLink() const noexcept { return description_->base_link; }
const std::string& KinematicChain::tipLink() const noexcept { return description_->tip_link; }
int KinematicChain::size() const noexcept { return static_cast<int>(joints_.size()); }
Joint& KinematicChain::joint(int i) noexcept { return *joints_[static_cast<std::size_t>(i)]; }
const Joint& KinematicChain::joint(int i) const noexcept { return *joints_[static_cast<std::size_t>(i)]; }

void KinematicChain::getJointPosition(Eigen::Ref<Eigen::VectorXd> q) const noexcept {
  gather(joints_, q, [](const Joint* j) { return j->getJointPosition(); });
}
void KinematicChain::getJointVelocity(Eigen::Ref<Eigen::VectorXd> qdot) const noexcept {
  gather(joints_, qdot, [](const Joint* j) { return j->getJointVelocity(); });
}
void KinematicChain::getJointEffort(Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  gather(joints_, tau, [](const Joint* j) { return j->getJointEffort(); });
}
void KinematicChain::setPositionReference(const Eigen::Ref<const Eigen::VectorXd>& q) noexcept {
  scatter(joints_, q, [](Joint* j, double v) { j->setPositionReference(v); });
}
void KinematicChain::setVelocityReference(const Eigen::Ref<const Eigen::VectorXd>& qdot) noexcept {
  scatter(joints_, qdot, [](Joint* j, double v) { j->setVelocityReference(v); });
}
void KinematicChain::setEffortReference(const Eigen::Ref<const Eigen::VectorXd>& tau) noexcept {
  scatter(joints_, tau, [](Joint* j, double v) { j->setEffortReference(v); });
}
void KinematicChain::setStiffness(const Eigen::Ref<const Eigen::VectorXd>& k) noexcept {
  scatter(joints_, k, [](Joint* j, double v) { j->setStiffness(v); });
}
void KinematicChain::setDamping(const Eigen::Ref<const Eigen::VectorXd>& d) noexcept {
  scatter(joints_, d, [](Joint* j, double v) { j->setDamping(v); });
}

}  // namespace robotui::rt
