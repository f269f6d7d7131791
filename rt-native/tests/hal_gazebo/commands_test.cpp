// Joints and sensors of a world that is well.
#include "rig.h"

namespace robotui::rt::hal::gazebo {
namespace {

TEST_F(GazeboTest, joints_follow_a_path_of_positions) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  double last = -1;
  bool backwards = false;
  for (int i = 1; i <= 500; ++i) {
    tell({i * 0.001, 0, 0, 0, 0, link::kPosition});
    cycle();
    backwards = backwards || joints[1].link_position < last - 1e-9;
    last = joints[1].link_position;
  }
  EXPECT_FALSE(backwards);
  EXPECT_TRUE(cycleUntil([&](Status) { return std::abs(joints[2].link_position - 0.5) < 1e-3; }))
      << joints[2].link_position << said;
  EXPECT_EQ(hal.dropped(), 0U);
}

TEST_F(GazeboTest, each_mode_goes_to_its_own_topic) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  tell({0, 0.4, 0, 0, 0, link::kVelocity});
  EXPECT_TRUE(cycleUntil([&](Status) { return std::abs(joints[0].link_velocity - 0.4) < 0.01; }));
  EXPECT_EQ(world->say("joint shoulder").front(), 'v');
  tell({0, 0, 3, 0, 0, link::kEffort});
  EXPECT_TRUE(cycleUntil([&](Status) { return joints[0].effort == 3; }));
  EXPECT_EQ(world->say("joint wrist").front(), 'e');
  EXPECT_EQ(told("gripper"), 0);  // no joint of this robot
}

TEST_F(GazeboTest, a_stiffness_becomes_an_effort_where_the_joint_takes_one) {
  begin({"controllers=e"});
  open();
  tell({0.3, 0, 0, 80, 12, link::kPosition | link::kImpedance});
  EXPECT_TRUE(cycleUntil([&](Status) {
    return std::abs(joints[1].link_position - 0.3) < 0.01 && std::abs(joints[1].link_velocity) < 0.01;
  })) << joints[1].link_position;
  EXPECT_EQ(world->say("joint elbow").front(), 'e');
}

TEST_F(GazeboTest, sensors_are_read_and_rest_until_they_speak) {
  begin();
  open();
  EXPECT_TRUE(
      cycleUntil([&](Status) { return imus[0].linear_acceleration[2] == 9.5 && force_torques[0].force[0] == 1; }));
  EXPECT_NEAR(imus[0].orientation[2], std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(imus[0].orientation[3], std::sqrt(0.5), 1e-9);
  EXPECT_EQ(imus[0].angular_velocity[2], 0.25);
  EXPECT_EQ(force_torques[0].force, (std::array<double, 3>{1, 2, 0}));
  EXPECT_EQ(force_torques[0].torque, (std::array<double, 3>{0, 0, 3}));
}

TEST_F(GazeboTest, the_thread_of_real_time_does_not_ask_the_heap) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  link::allocationCount().calls = 0;
  for (int i = 0; i < 300; ++i) {
    tell({i * 0.001, 0, 0, 0, 0, link::kPosition});
    {
      const link::CountAllocations count;
      hal.sense(measured);
      hal.move(references);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(link::allocationCount().calls, 0U);
}

TEST_F(GazeboTest, joints_that_nobody_moves_are_told) {
  begin({"controllers=v"});
  open();
  tell({0.2, 0, 0, 0, 0, link::kPosition});
  EXPECT_TRUE(cycleUntilSaid("does not listen to /model/arm/joint/shoulder/0/cmd_pos")) << said;
  EXPECT_NE(said.find("and 2 more likewise"), std::string::npos) << said;
  tell({0, 0.2, 0, 0, 0, link::kVelocity});
  EXPECT_TRUE(cycleUntilSaid("listens to the commands of all joints")) << said;
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
