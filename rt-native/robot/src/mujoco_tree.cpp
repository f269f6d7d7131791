#include "robotui/rt/robot/mujoco_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Eigenvalues>

namespace robotui::rt {
namespace {

constexpr double kLeastMass = 1e-6;
constexpr double kLeastInertia = 1e-9;

void setPlace(const Eigen::Isometry3d& place, double (&pos)[3], double (&quat)[4]) {
  Eigen::Map<Eigen::Vector3d>(static_cast<double*>(pos)) = place.translation();
  const Eigen::Quaterniond q(place.linear());
  quat[0] = q.w();
  quat[1] = q.x();
  quat[2] = q.y();
  quat[3] = q.z();
}

void setInertia(const RigidBody& from, mjsBody& body) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(from.inertia);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = principal.eigenvectors();
  if (frame.linear().determinant() < 0) frame.linear().col(2) *= -1;
  frame.translation() = from.com;
  setPlace(frame, body.ipos, body.iquat);
  Eigen::Map<Eigen::Vector3d>(static_cast<double*>(body.inertia)) = principal.eigenvalues();
  body.mass = from.mass;
  body.explicitinertial = 1;
}

mjsJoint* addJoint(const RigidBody& from, const config::JointDescription& description, mjsBody& body) {
  mjsJoint* joint = mjs_addJoint(&body, nullptr);
  mjs_setString(joint->name, description.name.c_str());
  joint->type = from.prismatic ? mjJNT_SLIDE : mjJNT_HINGE;
  Eigen::Map<Eigen::Vector3d>(static_cast<double*>(joint->axis)) = from.axis;
  return joint;
}

// Masses that MuJoCo refuses are raised to the least that it takes.
void setCompiler(mjsCompiler& compiler) {
  compiler.degree = 0;
  compiler.boundmass = kLeastMass;
  compiler.boundinertia = kLeastInertia;
  compiler.balanceinertia = 1;
  compiler.alignfree = 0;
  compiler.usethread = 0;
}

}  // namespace

MujocoTree addTree(const RigidTree& tree, const config::RobotDescription& robot, bool free_base) {
  MujocoTree result;
  result.spec.reset(mj_makeSpec());
  setCompiler(result.spec->compiler);
  result.spec->option.gravity[2] = -kGravity;
  result.joints.resize(robot.joints.size());
  for (const auto& from : tree.bodies) {
    mjsBody* parent = from.parent < 0 ? mjs_findBody(result.spec.get(), "world")
                                      : result.bodies[static_cast<std::size_t>(from.parent)];
    mjsBody* body = mjs_addBody(parent, nullptr);
    mjs_setString(body->name, from.name == "world" ? "robot world" : from.name.c_str());
    setPlace(from.placement, body->pos, body->quat);
    setInertia(from, *body);
    if (from.parent < 0 && free_base) mjs_addFreeJoint(body);
    const auto index = static_cast<std::size_t>(from.joint);
    if (from.joint >= 0) result.joints[index] = addJoint(from, robot.joints[index], *body);
    result.bodies.push_back(body);
  }
  return result;
}

MujocoModelPtr compile(const MujocoTree& tree, const std::string& robot) {
  MujocoModelPtr model(mj_compile(tree.spec.get(), nullptr));
  if (!model) throw std::runtime_error("MuJoCo refuses the robot '" + robot + "': " + mjs_getError(tree.spec.get()));
  return model;
}

MujocoDataPtr makeData(const mjModel& model) {
  MujocoDataPtr data(mj_makeData(&model));
  if (!data) throw std::runtime_error("MuJoCo has no memory for its data");
  return data;
}

}  // namespace robotui::rt
