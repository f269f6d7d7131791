// Models in states that chance chooses, always the same ones.
#pragma once

#include <algorithm>
#include <random>

#include "robotui/rt/robot/model_interface.h"

namespace robotui::rt {

class RandomState {
 public:
  explicit RandomState(unsigned seed = 7) : engine_(seed) {}

  Eigen::VectorXd vector(Eigen::Index size, double most) {
    std::uniform_real_distribution<double> value(-most, most);
    return Eigen::VectorXd::NullaryExpr(size, [&] { return value(engine_); });
  }

  // One random state for all of them.
  template <typename... Models>
  void put(Models&... models) {
    const auto first = std::get<0>(std::tie(models...)).getJointNum();
    const Eigen::VectorXd q = vector(first, 1.5);
    const Eigen::VectorXd qdot = vector(first, 2);
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.linear() = Eigen::Quaterniond(Eigen::Vector4d(vector(4, 1))).normalized().toRotationMatrix();
    base.translation() = vector(3, 2);
    const Eigen::Matrix<double, 6, 1> twist = vector(6, 1);
    (set(models, q, qdot, base, twist), ...);
  }

 private:
  static void set(ModelInterface& model, const Eigen::VectorXd& q, const Eigen::VectorXd& qdot,
                  const Eigen::Isometry3d& base, const Eigen::Matrix<double, 6, 1>& twist) {
    model.setJointPosition(q);
    model.setJointVelocity(qdot);
    model.setFloatingBase(base, twist);
    model.update();
  }

  std::mt19937 engine_;
};

}  // namespace robotui::rt
