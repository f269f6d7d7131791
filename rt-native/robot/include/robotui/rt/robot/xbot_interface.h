// The state of a robot, or of a model of one, as joints, chains and whole vectors (XBotInterface in the paper).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt {

// One joint. Views into storage that its interface owns; all reads and writes are plain memory accesses.
class Joint {
 public:
  Joint(const config::JointDescription& description, int index, link::JointState& state, link::JointCommand& command);

  const std::string& name() const noexcept;
  int id() const noexcept;
  int index() const noexcept;  // in the vectors of the whole robot
  const config::JointDescription& description() const noexcept;

  double getJointPosition() const noexcept;
  double getMotorPosition() const noexcept;
  double getJointVelocity() const noexcept;
  double getMotorVelocity() const noexcept;
  double getJointEffort() const noexcept;
  double getStiffness() const noexcept;  // as sent, like all references of the state
  double getDamping() const noexcept;
  double getPositionReference() const noexcept;
  double getVelocityReference() const noexcept;
  double getEffortReference() const noexcept;
  std::uint32_t fault() const noexcept;

  void setPositionReference(double rad) noexcept;  // sets the bit of the mode, too
  void setVelocityReference(double rad_s) noexcept;
  void setEffortReference(double nm) noexcept;
  void setStiffness(double nm_rad) noexcept;
  void setDamping(double nms_rad) noexcept;
  void setMode(std::uint8_t mode) noexcept;
  void clear() noexcept;  // commands nothing in this cycle

  const link::JointState& state() const noexcept;
  const link::JointCommand& command() const noexcept;

 private:
  const config::JointDescription* description_;
  int index_;
  link::JointState* state_;
  link::JointCommand* command_;
};

// The joints of one group of the SRDF, from base to tip. Vectors are in that order; sizes must fit (asserted in debug
// builds).
class KinematicChain {
 public:
  KinematicChain(const config::ChainDescription& description, std::vector<Joint*> joints);

  const std::string& name() const noexcept;
  const std::string& baseLink() const noexcept;
  const std::string& tipLink() const noexcept;
  int size() const noexcept;
  Joint& joint(int i) noexcept;
  const Joint& joint(int i) const noexcept;
  void getJointPosition(Eigen::Ref<Eigen::VectorXd> q) const noexcept;
  void getJointVelocity(Eigen::Ref<Eigen::VectorXd> qdot) const noexcept;
  void getJointEffort(Eigen::Ref<Eigen::VectorXd> tau) const noexcept;
  void setPositionReference(const Eigen::Ref<const Eigen::VectorXd>& q) noexcept;
  void setVelocityReference(const Eigen::Ref<const Eigen::VectorXd>& qdot) noexcept;
  void setEffortReference(const Eigen::Ref<const Eigen::VectorXd>& tau) noexcept;
  void setStiffness(const Eigen::Ref<const Eigen::VectorXd>& k) noexcept;
  void setDamping(const Eigen::Ref<const Eigen::VectorXd>& d) noexcept;

 private:
  const config::ChainDescription* description_;
  std::vector<Joint*> joints_;
};

struct Imu {
  std::string name;
  std::string link;
  const link::ImuState* state;
  Eigen::Quaterniond orientation() const noexcept;
  Eigen::Vector3d angularVelocity() const noexcept;
  Eigen::Vector3d linearAcceleration() const noexcept;
};

struct ForceTorque {
  std::string name;
  std::string link;
  const link::ForceTorqueState* state;
  Eigen::Vector3d force() const noexcept;
  Eigen::Vector3d torque() const noexcept;
};

// All joints, by index, name, id or chain. After construction nothing here allocates.
class XBotInterface {
 public:
  explicit XBotInterface(std::shared_ptr<const config::RobotDescription> description);
  virtual ~XBotInterface() = default;
  XBotInterface(const XBotInterface&) = delete;
  XBotInterface& operator=(const XBotInterface&) = delete;

  const config::RobotDescription& description() const noexcept;
  int getJointNum() const noexcept;
  Joint& joint(int index) noexcept;
  const Joint& joint(int index) const noexcept;
  Joint* findJoint(std::string_view name) noexcept;  // nullptr where there is none: the one optional of this API
  Joint* findJoint(int id) noexcept;
  KinematicChain* findChain(std::string_view name) noexcept;
  std::span<KinematicChain> chains() noexcept;
  std::span<const Imu> imus() const noexcept;
  std::span<const ForceTorque> forceTorques() const noexcept;

  void getJointPosition(Eigen::Ref<Eigen::VectorXd> q) const noexcept;
  void getMotorPosition(Eigen::Ref<Eigen::VectorXd> q) const noexcept;
  void getJointVelocity(Eigen::Ref<Eigen::VectorXd> qdot) const noexcept;
  void getMotorVelocity(Eigen::Ref<Eigen::VectorXd> qdot) const noexcept;
  void getJointEffort(Eigen::Ref<Eigen::VectorXd> tau) const noexcept;
  void getPositionReference(Eigen::Ref<Eigen::VectorXd> q) const noexcept;
  void setPositionReference(const Eigen::Ref<const Eigen::VectorXd>& q) noexcept;
  void setVelocityReference(const Eigen::Ref<const Eigen::VectorXd>& qdot) noexcept;
  void setEffortReference(const Eigen::Ref<const Eigen::VectorXd>& tau) noexcept;
  void setStiffness(const Eigen::Ref<const Eigen::VectorXd>& k) noexcept;
  void setDamping(const Eigen::Ref<const Eigen::VectorXd>& d) noexcept;

 protected:
  std::span<link::JointState> states() noexcept;
  std::span<link::JointCommand> commands() noexcept;
  std::span<link::ImuState> imuStates() noexcept;
  std::span<link::ForceTorqueState> forceTorqueStates() noexcept;

 private:
  std::shared_ptr<const config::RobotDescription> description_;
  std::vector<link::JointState> states_;
  std::vector<link::JointCommand> commands_;
  std::vector<link::ImuState> imu_states_;
  std::vector<link::ForceTorqueState> force_torque_states_;
  std::vector<Joint> joints_;
  std::vector<KinematicChain> chains_;
  std::vector<Imu> imus_;
  std::vector<ForceTorque> force_torques_;
};

// A robot that can be sensed and moved: over the link in a plugin host, over ROS in a node of a user.
class RobotInterface : public XBotInterface {
 public:
  using XBotInterface::XBotInterface;

  // Takes the newest state; false where there is none newer than the last.
  virtual bool sense() noexcept = 0;

  // Sends the references set since the last move(), of the joints that are owned; false where it cannot be sent.
  virtual bool move() noexcept = 0;
};

}  // namespace robotui::rt
