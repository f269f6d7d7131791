#include "transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace robotui::rt::ros_bridge {
namespace {

constexpr const char* kUrdf =
    R"(<robot name="r"><link name="base"/><link name="arm"/><link name="slide"/><link name="tool"/><link name="finger"/>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/><origin xyz="0 0 1"/><axis xyz="0 0 1"/></joint>
  <joint name="push" type="prismatic"><parent link="arm"/><child link="slide"/><origin rpy="0 0 1.5707963"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="1" velocity="1" effort="1"/></joint>
  <joint name="mount" type="fixed"><parent link="slide"/><child link="tool"/><origin xyz="0.1 0 0"/></joint>
  <joint name="follow" type="prismatic"><parent link="tool"/><child link="finger"/><axis xyz="0 1 0"/><limit lower="0" upper="1" velocity="1" effort="1"/>
    <mimic joint="push" multiplier="0.5" offset="0.01"/></joint></robot>)";

config::RobotDescription robot() {
  config::RobotDescription description{};
  description.urdf = kUrdf;
  description.joints = {{1, "turn", config::JointType::kRevolute, 0, 0, 1, 1},
                        {2, "push", config::JointType::kPrismatic, 0, 1, 1, 1}};
  return description;
}

const geometry_msgs::Transform& of(const std::vector<geometry_msgs::TransformStamped>& all, const std::string& link) {
  for (const auto& each : all) {
    if (each.child_frame_id == link) return each.transform;
  }
  throw std::runtime_error("no transform of " + link);
}

TEST(Transforms, FollowTheMeasuredJoints) {
  std::vector<link::JointState> joints(2);
  joints[0].link_position = M_PI / 2;
  joints[1].link_position = 0.4;
  const auto all = Transforms(robot()).moving(joints);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(of(all, "arm").translation.z, 1, 1e-9);
  EXPECT_NEAR(of(all, "arm").rotation.z, std::sin(M_PI / 4), 1e-9);
  EXPECT_NEAR(of(all, "slide").translation.y, 0.4, 1e-6) << "along the axis as it was turned by the origin";
  EXPECT_NEAR(of(all, "finger").translation.y, 0.21, 1e-9) << "mimics";
}

TEST(Transforms, FixedLinksAreSaidOnce) {
  const Transforms transforms(robot());
  ASSERT_EQ(transforms.fixed().size(), 1u);
  EXPECT_EQ(transforms.fixed().front().header.frame_id, "slide");
  EXPECT_NEAR(transforms.fixed().front().transform.translation.x, 0.1, 1e-9);
}

TEST(Transforms, AUrdfThatCannotBeReadIsSaid) {
  config::RobotDescription broken = robot();
  broken.urdf = "<robot";
  EXPECT_THROW(Transforms{broken}, std::runtime_error);
}

}  // namespace
}  // namespace robotui::rt::ros_bridge
