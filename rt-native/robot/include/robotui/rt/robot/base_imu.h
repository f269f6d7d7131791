// How a floating base is turned, as an IMU on it says.
#pragma once

#include "robotui/rt/robot/model_interface.h"

namespace robotui::rt {

class BaseImu {
 public:
  // Finds the first IMU that no joint turns against the base. Leaves the model with its base at the origin. Not real
  // time.
  explicit BaseImu(ModelInterface& model);

  // Of the robot's IMUs; -1 where none can tell.
  int index() const noexcept { return index_; }

  // Turns the model's base so that the sensor has this orientation in the world; what is no orientation turns nothing.
  // The model is to be updated then.
  void turn(ModelInterface& model, const Eigen::Quaterniond& sensor) const noexcept;

 private:
  int index_ = -1;
  Eigen::Matrix3d in_base_ = Eigen::Matrix3d::Identity();
};

}  // namespace robotui::rt
