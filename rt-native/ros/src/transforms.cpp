#include "transforms.h"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Geometry>
#include <urdf_parser/urdf_parser.h>

namespace robotui::rt::ros_bridge {
namespace {

bool isFixed(const urdf::Joint& joint) { return joint.type == urdf::Joint::FIXED; }

Eigen::Isometry3d originOf(const urdf::Joint& joint) {
  const auto& pose = joint.parent_to_joint_origin_transform;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  result.linear() = Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
                        .normalized()
                        .toRotationMatrix();
  return result;
}

Eigen::Isometry3d motionOf(const urdf::Joint& joint, double position) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (joint.type == urdf::Joint::PRISMATIC) {
    result.translation() = axis * position;
  } else if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS) {
    result.linear() = Eigen::AngleAxisd(position, axis.normalized()).toRotationMatrix();
  }
  return result;
}

geometry_msgs::TransformStamped message(const urdf::Joint& joint, const Eigen::Isometry3d& pose) {
  geometry_msgs::TransformStamped result;
  result.header.frame_id = joint.parent_link_name;
  result.child_frame_id = joint.child_link_name;
  result.transform.translation.x = pose.translation().x();
  result.transform.translation.y = pose.translation().y();
  result.transform.translation.z = pose.translation().z();
  const Eigen::Quaterniond turn(pose.linear());
  result.transform.rotation.x = turn.x();
  result.transform.rotation.y = turn.y();
  result.transform.rotation.z = turn.z();
  result.transform.rotation.w = turn.w();
  return result;
}

int indexOf(const config::RobotDescription& robot, const std::string& name) {
  const auto found =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const auto& joint) { return joint.name == name; });
  return found == robot.joints.end() ? -1 : static_cast<int>(found - robot.joints.begin());
}

}  // namespace

Transforms::Transforms(const config::RobotDescription& robot) : model_(urdf::parseURDF(robot.urdf)) {
  if (model_ == nullptr) throw std::runtime_error("The URDF of the robot " + robot.name + " cannot be read for /tf.");
  for (const auto& [name, joint] : model_->joints_) add(*joint, robot);
}

// A floating joint is that of the base: where the robot is in the world is for others to say.
void Transforms::add(const urdf::Joint& joint, const config::RobotDescription& robot) {
  if (isFixed(joint)) {
    fixed_.push_back(message(joint, originOf(joint)));
  } else if (joint.mimic) {
    moving_.push_back({&joint, indexOf(robot, joint.mimic->joint_name), joint.mimic->multiplier, joint.mimic->offset});
  } else if (joint.type != urdf::Joint::FLOATING) {
    moving_.push_back({&joint, indexOf(robot, joint.name), 1, 0});
  }
}

std::vector<geometry_msgs::TransformStamped> Transforms::moving(std::span<const link::JointState> joints) const {
  std::vector<geometry_msgs::TransformStamped> result;
  result.reserve(moving_.size());
  for (const Moving& each : moving_) {
    const bool known = each.source >= 0 && static_cast<std::size_t>(each.source) < joints.size();
    const double measured = known ? joints[static_cast<std::size_t>(each.source)].link_position : 0;
    result.push_back(
        message(*each.joint, originOf(*each.joint) * motionOf(*each.joint, each.factor * measured + each.offset)));
  }
  return result;
}

}  // namespace robotui::rt::ros_bridge
