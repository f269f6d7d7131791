// The efforts that hold a robot against gravity, for a control loop. A floating base is turned as the IMU on it says.
#pragma once

#include <memory>

#include "robotui/rt/plugin/control_plugin.h"
#include "robotui/rt/robot/base_imu.h"

namespace robotui::rt::plugins {

class GravityModel {
 public:
  // Not real time.
  explicit GravityModel(Setup& setup);

  // Efforts by index of the robot, for its measured positions.
  const Eigen::VectorXd& update(const RobotInterface& robot) noexcept;

  // As the robot was measured at the last update.
  const ModelInterface& model() const noexcept { return *model_; }

 private:
  std::unique_ptr<ModelInterface> model_;
  BaseImu base_;
  Eigen::VectorXd efforts_;  // of the whole model
  Eigen::VectorXd joints_;
};

}  // namespace robotui::rt::plugins
