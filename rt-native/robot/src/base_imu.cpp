#include "robotui/rt/robot/base_imu.h"

namespace robotui::rt {

using Twist = Eigen::Matrix<double, 6, 1>;

BaseImu::BaseImu(ModelInterface& model) {
  if (!model.isFloatingBase()) return;
  model.setFloatingBase(Eigen::Isometry3d::Identity(), Twist::Zero());
  model.update();
  Eigen::MatrixXd jacobian(6, model.getDofs());
  for (std::size_t i = 0; i < model.imus().size() && index_ < 0; ++i) {
    const LinkId link = model.findLink(model.imus()[i].link);
    Eigen::Isometry3d pose;
    if (!model.getJacobian(link, jacobian) || !jacobian.rightCols(model.getJointNum()).isZero()) continue;
    model.getPose(link, pose);
    in_base_ = pose.linear();
    index_ = static_cast<int>(i);
  }
}

void BaseImu::turn(ModelInterface& model, const Eigen::Quaterniond& sensor) const noexcept {
  if (index_ < 0 || !(sensor.norm() > 0.5)) return;
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.linear() = sensor.normalized().toRotationMatrix() * in_base_.transpose();
  model.setFloatingBase(base, Twist::Zero());
}

}  // namespace robotui::rt
