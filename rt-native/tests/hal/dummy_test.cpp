#include "dummy/dummy.h"

#include <gtest/gtest.h>

#include "rig.h"
#include "robotui/rt/hal/kinds.h"

namespace robotui::rt::hal {
namespace {

struct DummyTest : testing::Test {
  config::RobotDescription robot = robotOf(2);
  config::HalConfig config;
  std::array<link::JointState, 2> joints{};
  std::array<Reference, 2> references{};
  Measurements measured{joints, {}, {}};
  std::unique_ptr<Hal> hal;

  void open(const std::string& params = "{}") {
    config.type = "dummy";
    config.params = YAML::Load(params);
    hal = create(config);
    hal->open(robot, config, link::kMillisecond);
  }

  void move(const Reference& reference, int cycles) {
    references.fill(reference);
    for (int i = 0; i < cycles; ++i) hal->move(references);
    ASSERT_EQ(hal->sense(measured), Status::kOk);
  }
};

TEST_F(DummyTest, begins_at_zero_or_the_limit_nearest_to_it) {
  robot.joints[1].upper = -0.5;
  open();
  hal->sense(measured);
  EXPECT_EQ(joints[0].link_position, 0);
  EXPECT_EQ(joints[1].link_position, -0.5);
}

TEST_F(DummyTest, begins_in_a_posture) {
  robot.postures.push_back({"home", "arm", {{"joint_2", 0.7}}});
  open("{posture: home}");
  hal->sense(measured);
  EXPECT_EQ(joints[1].link_position, 0.7);
  EXPECT_THROW(open("{posture: away}"), config::ConfigError);
  EXPECT_THROW(open("{postur: home}"), config::ConfigError);
}

TEST_F(DummyTest, follows_positions_with_the_velocity_limit) {
  open();
  move({0.5, 0, 0, 0, 0, link::kPosition}, 250);
  EXPECT_NEAR(joints[0].link_position, 0.25, 1e-9);
  EXPECT_NEAR(joints[0].link_velocity, 1, 1e-9);
  move({0.5, 0, 0, 0, 0, link::kPosition}, 251);
  EXPECT_NEAR(joints[0].link_position, 0.5, 1e-9);
  EXPECT_NEAR(joints[0].link_velocity, 0, 1e-6);
}

TEST_F(DummyTest, integrates_velocities_up_to_the_limit_of_the_joint) {
  open();
  move({0, -0.5, 0, 0, 0, link::kVelocity}, 100);
  EXPECT_NEAR(joints[0].link_position, -0.05, 1e-9);
  move({0, -1, 0, 0, 0, link::kVelocity}, 4000);
  EXPECT_EQ(joints[0].link_position, -2);
  EXPECT_EQ(joints[0].link_velocity, 0);
}

TEST_F(DummyTest, efforts_accelerate_against_friction) {
  open();
  move({0, 0, 1, 0, 0, link::kEffort}, 1);
  EXPECT_NEAR(joints[0].link_velocity, 0.002, 1e-4);
  move({0, 0, 1, 0, 0, link::kEffort}, 2000);
  EXPECT_NEAR(joints[0].link_velocity, 0.5, 0.01);
  EXPECT_EQ(joints[0].effort, 1);
}

}  // namespace
}  // namespace robotui::rt::hal
