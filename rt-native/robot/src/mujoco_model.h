// The model on MuJoCo: the same dynamics as in the simulation.
#pragma once

#include <vector>

#include "robotui/rt/robot/model_interface.h"
#include "robotui/rt/robot/mujoco_tree.h"

namespace robotui::rt {

class MujocoModel final : public ModelInterface {
 public:
  explicit MujocoModel(std::shared_ptr<const config::RobotDescription> robot);

  bool isFloatingBase() const noexcept override { return offset_ != 0; }
  int getDofs() const noexcept override { return offset_ + getJointNum(); }
  LinkId findLink(std::string_view name) const override;
  void setFloatingBase(const Eigen::Isometry3d& world_base, const Eigen::Matrix<double, 6, 1>& twist) noexcept override;
  void update() noexcept override;
  bool getPose(LinkId link, Eigen::Isometry3d& world_link) const noexcept override;
  bool getJacobian(LinkId link, Eigen::Ref<Eigen::MatrixXd> jacobian) const noexcept override;
  void getInertiaMatrix(Eigen::Ref<Eigen::MatrixXd> m) const noexcept override;
  void computeGravityCompensation(Eigen::Ref<Eigen::VectorXd> tau) const noexcept override;
  void computeNonlinearTerm(Eigen::Ref<Eigen::VectorXd> tau) const noexcept override;
  void computeInverseDynamics(const Eigen::Ref<const Eigen::VectorXd>& qddot,
                              Eigen::Ref<Eigen::VectorXd> tau) const noexcept override;

 private:
  struct Place {
    int body;
    Eigen::Isometry3d in_body;
  };

  // MuJoCo's vectors are in the order of its tree, the base's angular part in the base's axes.
  void toUser(const std::vector<mjtNum>& from, Eigen::Ref<Eigen::VectorXd> to) const noexcept;
  bool isLink(LinkId link) const noexcept { return link.value >= 0 && link.value < static_cast<int>(links_.size()); }
  Eigen::Isometry3d poseOf(int body) const noexcept;
  Eigen::Matrix3d baseRotation() const noexcept;
  void takeExactInertias(const RigidTree& tree);

  int offset_;
  MujocoModelPtr model_;
  MujocoDataPtr data_;
  std::vector<int> body_ids_;  // of the tree's bodies
  std::vector<int> position_;  // in qpos, by joint
  std::vector<int> dof_;       // in qvel, by dof of the user
  std::vector<std::string> names_;
  std::vector<Place> links_;
  mutable std::vector<mjtNum> vector_;  // of one call; one thread uses a model
  mutable std::vector<mjtNum> matrix_;
  mutable std::vector<mjtNum> kept_;
};

}  // namespace robotui::rt
