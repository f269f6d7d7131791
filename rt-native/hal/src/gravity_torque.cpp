#include <algorithm>

#include "robotui/rt/robot/base_imu.h"
#include "safe_torque.h"

namespace robotui::rt::hal {

namespace {

class GravityTorque : public SafeTorque {
 public:
  GravityTorque(const std::shared_ptr<const config::RobotDescription>& robot, const std::string& model_type)
      : model_(ModelInterface::create(model_type, robot)), base_(*model_),
        position_(Eigen::VectorXd::Zero(model_->getJointNum())), torque_(Eigen::VectorXd::Zero(model_->getDofs())) {}

  void compute(const Measurements& measured, std::span<double> effort) noexcept override {
    for (Eigen::Index j = 0; j < position_.size(); ++j)
      position_[j] = measured.joints[static_cast<std::size_t>(j)].link_position;
    model_->setJointPosition(position_);
    if (base_.index() >= 0) turnBase(measured.imus[static_cast<std::size_t>(base_.index())]);
    model_->update();
    model_->computeGravityCompensation(torque_);
    const auto joints = torque_.tail(position_.size());
    std::copy(joints.begin(), joints.end(), effort.begin());
  }

 private:
  void turnBase(const link::ImuState& imu) noexcept {
    const auto& q = imu.orientation;
    base_.turn(*model_, Eigen::Quaterniond(q[3], q[0], q[1], q[2]));
  }

  std::unique_ptr<ModelInterface> model_;
  BaseImu base_;
  Eigen::VectorXd position_;
  Eigen::VectorXd torque_;
};

}  // namespace

std::unique_ptr<SafeTorque> makeGravityTorque(const std::shared_ptr<const config::RobotDescription>& robot,
                                              const std::string& model_type) {
  return std::make_unique<GravityTorque>(robot, model_type);
}

}  // namespace robotui::rt::hal
