#include "robotui/rt/robot/rigid_tree.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

namespace robotui::rt {
namespace {

Eigen::Vector3d vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  result.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  result.translation() = vector(pose.position);
  return result;
}

Eigen::Vector3d axisOf(const urdf::Joint& joint) {
  const Eigen::Vector3d axis = vector(joint.axis);
  if (axis.norm() < 1e-6) throw std::runtime_error("the joint '" + joint.name + "' of the URDF has no axis");
  return axis.normalized();
}

Eigen::Matrix3d pointInertia(double mass, const Eigen::Vector3d& at) {
  return mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
}

// Adds what is at `in_body` to the body: masses, moments about the common center of mass.
void addInertia(RigidBody& body, const urdf::Inertial& part, const Eigen::Isometry3d& in_body) {
  const Eigen::Isometry3d frame = in_body * isometry(part.origin);
  Eigen::Matrix3d own;
  own << part.ixx, part.ixy, part.ixz, part.ixy, part.iyy, part.iyz, part.ixz, part.iyz, part.izz;
  const double mass = body.mass + part.mass;
  const Eigen::Vector3d com =
      mass > 0 ? Eigen::Vector3d((body.mass * body.com + part.mass * frame.translation()) / mass) : body.com;
  body.inertia += pointInertia(body.mass, body.com - com) + frame.linear() * own * frame.linear().transpose() +
                  pointInertia(part.mass, frame.translation() - com);
  body.mass = mass;
  body.com = com;
}

// The parser talks of materials on stderr; what is wrong with a URDF was said when it was described.
urdf::ModelInterfaceSharedPtr parse(const std::string& text) {
  console_bridge::noOutputHandler();
  return urdf::parseURDF(text);
}

class Builder {
 public:
  Builder(const config::RobotDescription& robot, const std::set<std::string>& apart)
      : apart_(apart), model_(parse(robot.urdf)) {
    if (!model_ || !model_->getRoot()) throw std::runtime_error("the URDF of '" + robot.name + "' cannot be read");
    for (std::size_t i = 0; i < robot.joints.size(); ++i) index_[robot.joints[i].name] = static_cast<int>(i);
  }

  RigidTree build() {
    urdf::LinkConstSharedPtr root = model_->getRoot();
    if (root->child_joints.size() == 1 && root->child_joints[0]->type == urdf::Joint::FLOATING)
      root = root->child_links[0];
    RigidBody base;
    base.name = root->name;
    tree_.bodies.push_back(base);
    addLink(*root, 0, Eigen::Isometry3d::Identity());
    return std::move(tree_);
  }

 private:
  void addLink(const urdf::Link& link, int body, const Eigen::Isometry3d& in_body) {
    tree_.links[link.name] = {body, in_body};
    if (link.inertial) addInertia(tree_.bodies[static_cast<std::size_t>(body)], *link.inertial, in_body);
    for (const auto& collision : link.collision_array) addShape(*collision, link.name, body, in_body);
    const auto isMesh = [](const urdf::CollisionSharedPtr& collision) {
      return collision->geometry && collision->geometry->type == urdf::Geometry::MESH;
    };
    if (std::any_of(link.collision_array.begin(), link.collision_array.end(), isMesh))
      tree_.mesh_links.push_back(link.name);
    for (const auto& joint : link.child_joints)
      addJoint(*joint, body, in_body * isometry(joint->parent_to_joint_origin_transform));
  }

  void addJoint(const urdf::Joint& joint, int parent, const Eigen::Isometry3d& placement) {
    const urdf::LinkConstSharedPtr child = model_->getLink(joint.child_link_name);
    const auto index = index_.find(joint.name);
    if (index == index_.end() && !apart_.contains(child->name)) {
      addLink(*child, parent, placement);
      return;
    }
    RigidBody body;
    body.name = child->name;
    body.parent = parent;
    body.placement = placement;
    if (index != index_.end()) {
      body.joint = index->second;
      body.prismatic = joint.type == urdf::Joint::PRISMATIC;
      body.axis = axisOf(joint);
    }
    tree_.bodies.push_back(body);
    addLink(*child, static_cast<int>(tree_.bodies.size()) - 1, Eigen::Isometry3d::Identity());
  }

  void addShape(const urdf::Collision& collision, const std::string& link, int body, const Eigen::Isometry3d& in_body) {
    if (!collision.geometry) return;
    CollisionShape shape{CollisionShape::Kind::kBox, body, in_body * isometry(collision.origin), link,
                         Eigen::Vector3d::Zero()};
    if (const auto* box = dynamic_cast<const urdf::Box*>(collision.geometry.get())) {
      shape.size = vector(box->dim) / 2;
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision.geometry.get())) {
      shape.kind = CollisionShape::Kind::kSphere;
      shape.size.x() = sphere->radius;
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(collision.geometry.get())) {
      shape.kind = CollisionShape::Kind::kCylinder;
      shape.size = {cylinder->radius, cylinder->length / 2, 0};
    } else {
      return;
    }
    tree_.shapes.push_back(shape);
  }

  const std::set<std::string>& apart_;
  urdf::ModelInterfaceSharedPtr model_;
  std::map<std::string, int> index_;
  RigidTree tree_;
};

}  // namespace

double RigidTree::mass() const {
  return std::accumulate(bodies.begin(), bodies.end(), 0.0,
                         [](double sum, const RigidBody& body) { return sum + body.mass; });
}

RigidTree buildRigidTree(const config::RobotDescription& robot, const std::set<std::string>& apart) {
  return Builder(robot, apart).build();
}

}  // namespace robotui::rt
