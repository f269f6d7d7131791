// The frames of all links from the positions of the joints: what the robot state publisher of ROS does.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/layout.h"

namespace urdf {
class Joint;
class ModelInterface;
}  // namespace urdf

namespace robotui::rt::ros_bridge {

class Transforms {
 public:
  // Throws std::runtime_error where the URDF cannot be read.
  explicit Transforms(const config::RobotDescription& robot);

  // Of the links that joints move; `joints` are those of the robot, in its order. A joint that is not commanded, and
  // mimics none, is at zero.
  std::vector<geometry_msgs::TransformStamped> moving(std::span<const link::JointState> joints) const;

  // Of the links that are fixed to their parents.
  const std::vector<geometry_msgs::TransformStamped>& fixed() const noexcept { return fixed_; }

 private:
  struct Moving {
    const urdf::Joint* joint;
    int source;     // joint of the robot that it follows; -1 is none
    double factor;  // 1 but where it mimics
    double offset;
  };
  void add(const urdf::Joint& joint, const config::RobotDescription& robot);

  std::shared_ptr<const urdf::ModelInterface> model_;
  std::vector<Moving> moving_;
  std::vector<geometry_msgs::TransformStamped> fixed_;
};

}  // namespace robotui::rt::ros_bridge
