// The chain whose tip a Cartesian plugin leads, in the frame of the chain's base link.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

class ChainFrame {
 public:
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  // That of the parameter `chain`, which may be left out where the robot has one alone. Its joints are claimed. False
  // after setup.fail(why). Not real time.
  bool find(Setup& setup, const config::Reader& params, const ModelInterface& model);

  const std::vector<Joint*>& joints() const noexcept { return joints_; }
  int inModel(std::size_t joint) const noexcept { return in_model_[joint]; }
  const std::string& baseLink() const noexcept { return base_name_; }
  const std::string& tipLink() const noexcept { return tip_name_; }

  // Both as the model is now; the columns are the joints of the chain.
  Eigen::Isometry3d tip(const ModelInterface& model) const noexcept;
  const Jacobian& jacobian(const ModelInterface& model) noexcept;

 private:
  std::string base_name_;
  std::string tip_name_;
  LinkId base_;
  LinkId tip_;
  std::vector<Joint*> joints_;
  std::vector<int> in_model_;
  Eigen::MatrixXd whole_;  // of the model, in the world's axes
  Jacobian reduced_;
};

}  // namespace robotui::rt::plugins
