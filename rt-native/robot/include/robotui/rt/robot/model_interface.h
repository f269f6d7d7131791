// Kinematics and dynamics of a robot (ModelInterface in the paper), whatever library computes them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt {

// A place on the model, found once outside the control loop.
struct LinkId {
  int value = -1;
  bool isValid() const noexcept { return value >= 0; }
};

// A model has a state of its own (the joints of its XBotInterface): set it, update(), ask. Vectors of the whole model
// have getDofs() elements: six of the floating base first where there is one (linear, angular; in the world's axes),
// then the joints by index. Joints of the URDF that are not in the joint map are held at zero. Gravity is 9.81 m/s2
// along the world's -z. Nothing allocates after construction but create() and find...(). One thread uses a model.
class ModelInterface : public XBotInterface {
 public:
  using XBotInterface::XBotInterface;

  // Back-ends that are built in, by the name of `model_type`, such as "KDL" or "MUJOCO".
  static std::vector<std::string> types();

  // Throws std::runtime_error with a sentence that names the type and what there is.
  static std::unique_ptr<ModelInterface> create(std::string_view type,
                                                std::shared_ptr<const config::RobotDescription> robot);

  virtual bool isFloatingBase() const noexcept = 0;
  virtual int getDofs() const noexcept = 0;
  virtual LinkId findLink(std::string_view name) const = 0;

  // The joints' state, all of them by index.
  void setJointPosition(const Eigen::Ref<const Eigen::VectorXd>& q) noexcept;
  void setJointVelocity(const Eigen::Ref<const Eigen::VectorXd>& qdot) noexcept;
  void setJointEffort(const Eigen::Ref<const Eigen::VectorXd>& tau) noexcept;

  // Copies positions, velocities, efforts of all joints that both have, by name; then update().
  void syncFrom(const XBotInterface& other) noexcept;
  // Prepares the pairs of joints for another interface, so that syncFrom and syncTo do not search. Outside the loop.
  void pair(const XBotInterface& other);
  // Position references, where one is set, of all joints that both have.
  void syncTo(XBotInterface& other) const noexcept;

  // Where the base is and how it moves (linear, angular; in the world's axes). Without effect on a robot with a fixed
  // base.
  virtual void setFloatingBase(const Eigen::Isometry3d& world_base,
                               const Eigen::Matrix<double, 6, 1>& twist) noexcept = 0;

  // Brings everything below up to the joints' state.
  virtual void update() noexcept = 0;

  virtual bool getPose(LinkId link, Eigen::Isometry3d& world_link) const noexcept = 0;
  // 6 x getDofs(), linear over angular, at the link's origin, in the world's axes.
  virtual bool getJacobian(LinkId link, Eigen::Ref<Eigen::MatrixXd> jacobian) const noexcept = 0;
  virtual void getInertiaMatrix(Eigen::Ref<Eigen::MatrixXd> m) const noexcept = 0;
  virtual void computeGravityCompensation(Eigen::Ref<Eigen::VectorXd> tau) const noexcept = 0;
  virtual void computeNonlinearTerm(
      Eigen::Ref<Eigen::VectorXd> tau) const noexcept = 0;  // Coriolis, centrifugal, gravity
  virtual void computeInverseDynamics(const Eigen::Ref<const Eigen::VectorXd>& qddot,
                                      Eigen::Ref<Eigen::VectorXd> tau) const noexcept = 0;

 private:
  const XBotInterface* paired_ = nullptr;
  std::vector<std::pair<int, int>> pairs_;  // own index, other's index
};

}  // namespace robotui::rt
