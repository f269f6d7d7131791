#include "mujoco_model.h"

#include <algorithm>

namespace robotui::rt {
namespace {

using RowMajor = Eigen::Matrix<mjtNum, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

MujocoModel::MujocoModel(std::shared_ptr<const config::RobotDescription> robot)
    : ModelInterface(std::move(robot)), offset_(description().floating_base ? 6 : 0) {
  const RigidTree tree = buildRigidTree(description());
  const MujocoTree mujoco = addTree(tree, description(), offset_ != 0);
  model_ = compile(mujoco, description().name);
  for (const mjsBody* body : mujoco.bodies) body_ids_.push_back(mjs_getId(body->element));
  for (int i = 0; i < offset_; ++i) dof_.push_back(i);
  for (const mjsJoint* joint : mujoco.joints) {
    const int id = mjs_getId(joint->element);
    position_.push_back(model_->jnt_qposadr[id]);
    dof_.push_back(model_->jnt_dofadr[id]);
  }
  for (const auto& [name, frame] : tree.links) {
    names_.push_back(name);
    links_.push_back({body_ids_[at(frame.body)], frame.in_body});
  }
  takeExactInertias(tree);
  data_ = makeData(*model_);
  mj_setConst(model_.get(), data_.get());
  mj_resetData(model_.get(), data_.get());
  vector_.resize(at(getDofs()));
  matrix_.resize(at(getDofs()) * at(std::max(getDofs(), 6)));
  kept_.resize(at(6 * model_->nbody + getDofs()));
  update();
}

// The compiler rounds inertias up to what is possible for a body, as a simulation needs it; a model says what the URDF
// says.
void MujocoModel::takeExactInertias(const RigidTree& tree) {
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const RigidBody& body = tree.bodies[i];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(body.inertia);
    Eigen::Matrix3d axes = principal.eigenvectors();
    if (axes.determinant() < 0) axes.col(2) *= -1;
    const Eigen::Quaterniond q(axes);
    const int id = body_ids_[i];
    model_->body_mass[id] = body.mass;
    Eigen::Map<Eigen::Vector3d>(model_->body_inertia + 3 * id) = principal.eigenvalues();
    Eigen::Map<Eigen::Vector4d>(model_->body_iquat + 4 * id) << q.w(), q.x(), q.y(), q.z();
  }
}

LinkId MujocoModel::findLink(std::string_view name) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i] == name) return {static_cast<int>(i)};
  }
  return {};
}

void MujocoModel::setFloatingBase(const Eigen::Isometry3d& world_base,
                                  const Eigen::Matrix<double, 6, 1>& twist) noexcept {
  if (offset_ == 0) return;
  const Eigen::Quaterniond q(world_base.linear());
  Eigen::Map<Eigen::Matrix<mjtNum, 7, 1>>(data_->qpos) << world_base.translation(), q.w(), q.x(), q.y(), q.z();
  Eigen::Map<Eigen::Matrix<mjtNum, 6, 1>>(data_->qvel) << twist.head<3>(),
      world_base.linear().transpose() * twist.tail<3>();
}

void MujocoModel::update() noexcept {
  for (int i = 0; i < getJointNum(); ++i) {
    data_->qpos[position_[at(i)]] = joint(i).getJointPosition();
    data_->qvel[dof_[at(offset_ + i)]] = joint(i).getJointVelocity();
  }
  mj_kinematics(model_.get(), data_.get());
  mj_comPos(model_.get(), data_.get());
  mj_comVel(model_.get(), data_.get());
}

Eigen::Isometry3d MujocoModel::poseOf(int body) const noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * body);
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body);
  return pose;
}

Eigen::Matrix3d MujocoModel::baseRotation() const noexcept { return poseOf(body_ids_[0]).linear(); }

bool MujocoModel::getPose(LinkId link, Eigen::Isometry3d& world_link) const noexcept {
  if (!isLink(link)) return false;
  const Place& place = links_[at(link.value)];
  world_link = poseOf(place.body) * place.in_body;
  return true;
}

bool MujocoModel::getJacobian(LinkId link, Eigen::Ref<Eigen::MatrixXd> jacobian) const noexcept {
  Eigen::Isometry3d pose;
  const int n = getDofs();
  if (!getPose(link, pose) || jacobian.rows() != 6 || jacobian.cols() != n) return false;
  mj_jac(model_.get(), data_.get(), matrix_.data(), matrix_.data() + 3 * n, pose.translation().data(),
         links_[at(link.value)].body);
  const Eigen::Map<const RowMajor> found(matrix_.data(), 6, n);
  for (int i = 0; i < n; ++i) jacobian.col(i) = found.col(dof_[at(i)]);
  if (offset_ == 0) return true;
  const Eigen::Matrix<double, 6, 3> turned = jacobian.middleCols<3>(3).lazyProduct(baseRotation().transpose());
  jacobian.middleCols<3>(3) = turned;
  return true;
}

void MujocoModel::getInertiaMatrix(Eigen::Ref<Eigen::MatrixXd> m) const noexcept {
  const int n = getDofs();
  mj_crb(model_.get(), data_.get());
  mj_fullM(model_.get(), matrix_.data(), data_->qM);
  const Eigen::Map<const RowMajor> found(matrix_.data(), n, n);
  for (int column = 0; column < n; ++column) {
    for (int row = 0; row < n; ++row) m(row, column) = found(dof_[at(row)], dof_[at(column)]);
  }
  if (offset_ == 0) return;
  const Eigen::Matrix3d turn = baseRotation();
  for (int column = 0; column < n; ++column) {
    const Eigen::Vector3d turned = turn * m.block<3, 1>(3, column);
    m.block<3, 1>(3, column) = turned;
  }
  for (int row = 0; row < n; ++row) {
    const Eigen::RowVector3d turned = m.block<1, 3>(row, 3) * turn.transpose();
    m.block<1, 3>(row, 3) = turned;
  }
}

void MujocoModel::toUser(const std::vector<mjtNum>& from, Eigen::Ref<Eigen::VectorXd> to) const noexcept {
  for (int i = 0; i < getDofs(); ++i) to[i] = from[at(dof_[at(i)])];
  if (offset_ == 0) return;
  const Eigen::Vector3d turned = baseRotation() * to.segment<3>(3);
  to.segment<3>(3) = turned;
}

// The velocities are put aside: without them the recursion is that of a robot at rest.
void MujocoModel::computeGravityCompensation(Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  const int bodies = 6 * model_->nbody;
  const int n = getDofs();
  std::copy_n(data_->cvel, bodies, kept_.begin());
  std::copy_n(data_->qvel, n, kept_.begin() + bodies);
  std::fill_n(data_->cvel, bodies, 0.0);
  std::fill_n(data_->qvel, n, 0.0);
  mj_rne(model_.get(), data_.get(), 0, vector_.data());
  std::copy_n(kept_.begin(), bodies, data_->cvel);
  std::copy_n(kept_.begin() + bodies, n, data_->qvel);
  toUser(vector_, tau);
}

void MujocoModel::computeNonlinearTerm(Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  mj_rne(model_.get(), data_.get(), 0, vector_.data());
  toUser(vector_, tau);
}

void MujocoModel::computeInverseDynamics(const Eigen::Ref<const Eigen::VectorXd>& qddot,
                                         Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  for (int i = 0; i < getDofs(); ++i) data_->qacc[dof_[at(i)]] = qddot[i];
  if (offset_ != 0) Eigen::Map<Eigen::Vector3d>(data_->qacc + 3) = baseRotation().transpose() * qddot.segment<3>(3);
  mj_rne(model_.get(), data_.get(), 1, vector_.data());
  toUser(vector_, tau);
}

}  // namespace robotui::rt
