// The model on KDL's vectors and inertias, with recursions over the tree of our own: KDL's solvers know chains and
// fixed bases.
#pragma once

#include <vector>

#include <kdl/frames.hpp>
#include <kdl/rigidbodyinertia.hpp>

#include "robotui/rt/robot/model_interface.h"
#include "robotui/rt/robot/rigid_tree.h"

namespace robotui::rt {

class KdlModel final : public ModelInterface {
 public:
  explicit KdlModel(std::shared_ptr<const config::RobotDescription> robot);

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
  struct Body {
    int parent;
    int joint;
    bool prismatic;
    KDL::Frame placement;
    KDL::Twist motion;  // of a unit of joint velocity, in its own frame
    KDL::RigidBodyInertia inertia;
    KDL::Frame in_parent;  // at the joint's position
    KDL::Frame in_world;
    KDL::Twist velocity;  // in its own frame
    double rate;
  };
  struct Scratch {
    KDL::Twist acceleration;
    KDL::Wrench force;
    KDL::RigidBodyInertia composite;
  };
  struct Place {
    int body;
    KDL::Frame in_body;
  };

  bool isLink(LinkId link) const noexcept { return link.value >= 0 && link.value < static_cast<int>(links_.size()); }
  KDL::Frame worldOf(LinkId link) const noexcept;
  KDL::Twist baseAcceleration(const Eigen::Ref<const Eigen::VectorXd>* qddot, bool moving) const noexcept;
  void recurse(const Eigen::Ref<const Eigen::VectorXd>* qddot, bool moving,
               Eigen::Ref<Eigen::VectorXd> tau) const noexcept;
  void putBaseWrench(const KDL::Wrench& in_base, Eigen::Ref<Eigen::MatrixXd> m, Eigen::Index column) const noexcept;

  int offset_;
  std::vector<Body> bodies_;
  mutable std::vector<Scratch> scratch_;  // of one call; one thread uses a model
  std::vector<std::string> names_;
  std::vector<Place> links_;
};

}  // namespace robotui::rt
