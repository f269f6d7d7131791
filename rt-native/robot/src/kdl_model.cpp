#include "kdl_model.h"

namespace robotui::rt {
namespace {

const KDL::Vector kDown(0, 0, -kGravity);

KDL::Vector toKdl(const Eigen::Vector3d& v) noexcept { return {v.x(), v.y(), v.z()}; }

KDL::Frame toKdl(const Eigen::Isometry3d& t) noexcept {
  const auto& r = t.matrix();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          toKdl(Eigen::Vector3d(t.translation()))};
}

KDL::RigidBodyInertia toKdl(const RigidBody& b) {
  const auto& i = b.inertia;
  return KDL::RigidBodyInertia(b.mass, toKdl(b.com),
                               KDL::RotationalInertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)));
}

Eigen::Vector3d toEigen(const KDL::Vector& v) noexcept { return {v.x(), v.y(), v.z()}; }

}  // namespace

KdlModel::KdlModel(std::shared_ptr<const config::RobotDescription> robot)
    : ModelInterface(std::move(robot)), offset_(description().floating_base ? 6 : 0) {
  const RigidTree tree = buildRigidTree(description());
  for (const auto& body : tree.bodies) {
    const KDL::Vector axis = toKdl(body.axis);
    const KDL::Twist motion =
        body.prismatic ? KDL::Twist(axis, KDL::Vector::Zero()) : KDL::Twist(KDL::Vector::Zero(), axis);
    bodies_.push_back({body.parent, body.joint, body.prismatic, toKdl(body.placement), motion, toKdl(body),
                       KDL::Frame::Identity(), KDL::Frame::Identity(), KDL::Twist::Zero(), 0});
  }
  scratch_.resize(bodies_.size());
  for (const auto& [name, frame] : tree.links) {
    names_.push_back(name);
    links_.push_back({frame.body, toKdl(frame.in_body)});
  }
  update();
}

LinkId KdlModel::findLink(std::string_view name) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i] == name) return {static_cast<int>(i)};
  }
  return {};
}

void KdlModel::setFloatingBase(const Eigen::Isometry3d& world_base, const Eigen::Matrix<double, 6, 1>& twist) noexcept {
  if (offset_ == 0) return;
  Body& base = bodies_[0];
  base.in_world = toKdl(world_base);
  base.velocity = base.in_world.M.Inverse(
      KDL::Twist(toKdl(Eigen::Vector3d(twist.head<3>())), toKdl(Eigen::Vector3d(twist.tail<3>()))));
}

void KdlModel::update() noexcept {
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    const Joint& moved = joint(body.joint);
    const double q = moved.getJointPosition();
    body.rate = moved.getJointVelocity();
    const KDL::Frame by =
        body.prismatic ? KDL::Frame(body.motion.vel * q) : KDL::Frame(KDL::Rotation::Rot2(body.motion.rot, q));
    body.in_parent = body.placement * by;
    const Body& parent = bodies_[static_cast<std::size_t>(body.parent)];
    body.in_world = parent.in_world * body.in_parent;
    body.velocity = body.in_parent.Inverse(parent.velocity) + body.motion * body.rate;
  }
}

KDL::Frame KdlModel::worldOf(LinkId link) const noexcept {
  const Place& place = links_[static_cast<std::size_t>(link.value)];
  return bodies_[static_cast<std::size_t>(place.body)].in_world * place.in_body;
}

bool KdlModel::getPose(LinkId link, Eigen::Isometry3d& world_link) const noexcept {
  if (!isLink(link)) return false;
  const KDL::Frame frame = worldOf(link);
  world_link.setIdentity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) world_link(row, column) = frame.M(row, column);
  }
  world_link.translation() = toEigen(frame.p);
  return true;
}

bool KdlModel::getJacobian(LinkId link, Eigen::Ref<Eigen::MatrixXd> jacobian) const noexcept {
  if (!isLink(link) || jacobian.rows() != 6 || jacobian.cols() != getDofs()) return false;
  jacobian.setZero();
  const KDL::Vector at = worldOf(link).p;
  for (int b = links_[static_cast<std::size_t>(link.value)].body; b > 0;
       b = bodies_[static_cast<std::size_t>(b)].parent) {
    const Body& body = bodies_[static_cast<std::size_t>(b)];
    const KDL::Twist twist = (body.in_world.M * body.motion).RefPoint(at - body.in_world.p);
    jacobian.col(offset_ + body.joint) << toEigen(twist.vel), toEigen(twist.rot);
  }
  if (offset_ == 0) return true;
  const Eigen::Vector3d arm = toEigen(at - bodies_[0].in_world.p);
  jacobian.leftCols<6>().setIdentity();
  jacobian.block<3, 3>(0, 3) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  return true;
}

// Spatial acceleration of the base in its own frame, gravity included as if the base were pushed up against it.
KDL::Twist KdlModel::baseAcceleration(const Eigen::Ref<const Eigen::VectorXd>* qddot, bool moving) const noexcept {
  const Body& base = bodies_[0];
  KDL::Twist acceleration(-kDown, KDL::Vector::Zero());
  if (offset_ != 0 && qddot != nullptr) {
    acceleration +=
        KDL::Twist(toKdl(Eigen::Vector3d(qddot->segment<3>(0))), toKdl(Eigen::Vector3d(qddot->segment<3>(3))));
  }
  acceleration = base.in_world.M.Inverse(acceleration);
  if (moving)
    acceleration.vel -=
        base.velocity.rot * base.velocity.vel;  // what is asked is the derivative of the velocity of a point
  return acceleration;
}

// The recursive Newton-Euler algorithm in the bodies' own frames.
void KdlModel::recurse(const Eigen::Ref<const Eigen::VectorXd>* qddot, bool moving,
                       Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  scratch_[0].acceleration = baseAcceleration(qddot, moving);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    Scratch& at = scratch_[i];
    if (i > 0) {
      at.acceleration = body.in_parent.Inverse(scratch_[static_cast<std::size_t>(body.parent)].acceleration);
      if (qddot != nullptr) at.acceleration += body.motion * (*qddot)[offset_ + body.joint];
      if (moving) at.acceleration += body.velocity * (body.motion * body.rate);
    }
    at.force = body.inertia * at.acceleration;
    if (moving) at.force += body.velocity * (body.inertia * body.velocity);
  }
  for (std::size_t i = bodies_.size() - 1; i > 0; --i) {
    const Body& body = bodies_[i];
    tau[offset_ + body.joint] = KDL::dot(body.motion, scratch_[i].force);
    scratch_[static_cast<std::size_t>(body.parent)].force += body.in_parent * scratch_[i].force;
  }
  if (offset_ == 0) return;
  const KDL::Wrench world = bodies_[0].in_world.M * scratch_[0].force;
  tau.head<6>() << toEigen(world.force), toEigen(world.torque);
}

void KdlModel::putBaseWrench(const KDL::Wrench& in_base, Eigen::Ref<Eigen::MatrixXd> m,
                             Eigen::Index column) const noexcept {
  const KDL::Wrench world = bodies_[0].in_world.M * in_base;
  m.block<3, 1>(0, column) = toEigen(world.force);
  m.block<3, 1>(3, column) = toEigen(world.torque);
  if (column >= 6) m.block<1, 6>(column, 0) = m.block<6, 1>(0, column).transpose();
}

// The composite rigid body algorithm: forces that a unit acceleration of one joint needs along the way to the base.
void KdlModel::getInertiaMatrix(Eigen::Ref<Eigen::MatrixXd> m) const noexcept {
  m.setZero();
  for (std::size_t i = 0; i < bodies_.size(); ++i) scratch_[i].composite = bodies_[i].inertia;
  for (std::size_t i = bodies_.size() - 1; i > 0; --i) {
    Scratch& parent = scratch_[static_cast<std::size_t>(bodies_[i].parent)];
    parent.composite = parent.composite + bodies_[i].in_parent * scratch_[i].composite;
  }
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    KDL::Wrench force = scratch_[i].composite * bodies_[i].motion;
    const Eigen::Index row = offset_ + bodies_[i].joint;
    for (std::size_t j = i; j > 0; j = static_cast<std::size_t>(bodies_[j].parent)) {
      const Eigen::Index column = offset_ + bodies_[j].joint;
      m(row, column) = m(column, row) = KDL::dot(bodies_[j].motion, force);
      force = bodies_[j].in_parent * force;
    }
    if (offset_ != 0) putBaseWrench(force, m, row);
  }
  for (int column = 0; column < offset_; ++column) {
    KDL::Twist unit = KDL::Twist::Zero();
    unit(column) = 1;
    putBaseWrench(scratch_[0].composite * bodies_[0].in_world.M.Inverse(unit), m, column);
  }
}

void KdlModel::computeGravityCompensation(Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  recurse(nullptr, false, tau);
}

void KdlModel::computeNonlinearTerm(Eigen::Ref<Eigen::VectorXd> tau) const noexcept { recurse(nullptr, true, tau); }

void KdlModel::computeInverseDynamics(const Eigen::Ref<const Eigen::VectorXd>& qddot,
                                      Eigen::Ref<Eigen::VectorXd> tau) const noexcept {
  recurse(&qddot, true, tau);
}

}  // namespace robotui::rt
