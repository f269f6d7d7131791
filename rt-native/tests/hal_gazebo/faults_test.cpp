// A simulator that is not there, is lost, or says what cannot be.
#include "rig.h"

namespace robotui::rt::hal::gazebo {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(GazeboTest, without_a_simulator_the_place_and_the_remedy_are_named) {
  const std::string why = refusal();
  EXPECT_TRUE(contains(why, "No Gazebo was found in the partition '" + partition + "' at 127.0.0.1")) << why;
  EXPECT_TRUE(contains(why, "start it")) << why;
}

TEST_F(GazeboTest, another_model_is_named) {
  begin();
  const std::string why = refusal(", model: leg");
  EXPECT_TRUE(contains(why, "Nobody sends /world/default/model/leg/joint_state")) << why;
  EXPECT_TRUE(contains(why, "there is /world/default/model/arm/joint_state")) << why;
}

TEST_F(GazeboTest, a_joint_that_the_model_has_not_is_named) {
  begin();
  robot = armOf({"shoulder", "elbow", "knee"});
  const std::string why = refusal();
  EXPECT_TRUE(contains(why, "has no joint 'knee'")) << why;
  EXPECT_TRUE(contains(why, "elbow, gripper, shoulder, wrist")) << why;
}

TEST_F(GazeboTest, a_silent_simulator_is_a_time_out_and_nothing_is_sent_to_it) {
  begin();
  open();
  tell({0.1, 0, 0, 0, 0, link::kPosition});
  ASSERT_TRUE(cycleUntil([&](Status) { return std::abs(joints[0].link_position - 0.1) < 0.01; }));
  world->say("silent");
  ASSERT_TRUE(cycleUntil(Status::kTimeout));
  EXPECT_TRUE(cycleUntilSaid("The joint 'shoulder' and all others of the model 'arm' are silent")) << said;
  EXPECT_TRUE(contains(said, "no newer state comes on /world/default/model/arm/joint_state")) << said;
  const int before = told("elbow");
  tell({0.9, 0, 0, 0, 0, link::kPosition});
  for (int i = 0; i < 300; ++i) cycle();
  EXPECT_EQ(told("elbow"), before);
  world->say("speak");
  EXPECT_TRUE(cycleUntil(Status::kOk));
  EXPECT_TRUE(cycleUntilSaid("The simulator sends again")) << said;
}

TEST_F(GazeboTest, a_simulator_that_is_killed_is_told_and_another_one_is_found) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  world.reset();
  EXPECT_TRUE(cycleUntil(Status::kTimeout));
  EXPECT_TRUE(cycleUntilSaid("Nobody offers /world/default/model/arm/joint_state any more")) << said;
  begin();
  EXPECT_TRUE(cycleUntil(Status::kOk)) << said;
  tell({0.2, 0, 0, 0, 0, link::kPosition});
  EXPECT_TRUE(cycleUntil([&](Status) { return std::abs(joints[0].link_position - 0.2) < 0.01; }));
}

TEST_F(GazeboTest, what_is_no_number_is_a_fault_of_its_joint) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  world->say("nan elbow");
  EXPECT_TRUE(cycleUntil(Status::kFault));
  EXPECT_EQ(joints[0].fault, 0U);
  EXPECT_EQ(joints[1].fault, 1U);
  EXPECT_TRUE(std::isfinite(joints[1].link_position));
  EXPECT_TRUE(cycleUntilSaid("The state of the joint 'elbow' on /world/default/model/arm/joint_state is no number"))
      << said;
  world->say("sound");
  EXPECT_TRUE(cycleUntil(Status::kOk));
  EXPECT_EQ(joints[1].fault, 0U);
  EXPECT_TRUE(cycleUntilSaid("are sound again")) << said;
}

TEST_F(GazeboTest, a_sensor_that_says_no_number_keeps_its_last_value) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil([&](Status) { return imus[0].linear_acceleration[2] == 9.5; }));
  world->say("nan imu");
  EXPECT_TRUE(cycleUntilSaid("is no sound IMU")) << said;
  EXPECT_EQ(imus[0].linear_acceleration[2], 9.5);
  EXPECT_EQ(cycle(), Status::kOk);
}

TEST_F(GazeboTest, a_state_that_lost_a_joint_is_dropped) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  world->say("lack wrist");
  EXPECT_TRUE(cycleUntil(Status::kTimeout));
  EXPECT_TRUE(cycleUntilSaid("lacks the joint 'wrist'")) << said;
  world->say("sound");
  EXPECT_TRUE(cycleUntil(Status::kOk));
}

TEST_F(GazeboTest, messages_of_other_types_are_dropped) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  const WorldProcess stranger({"partition=" + partition, "strange"});
  EXPECT_TRUE(cycleUntilSaid("come messages of the type ignition.msgs.Double")) << said;
  EXPECT_GT(hal.dropped(), 0U);
  EXPECT_TRUE(cycleUntil(Status::kOk));
}

TEST_F(GazeboTest, messages_of_another_type_alone_are_named) {
  const WorldProcess stranger({"partition=" + partition, "strange"});
  const std::string why = refusal();
  EXPECT_TRUE(contains(why, "come messages of the type ignition.msgs.Double")) << why;
  EXPECT_TRUE(contains(why, "HALInterface.params.topics.joint_state")) << why;
}

TEST_F(GazeboTest, broken_messages_are_dropped) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  world->say("garbage");
  EXPECT_TRUE(cycleUntilSaid("cannot be read as a Model with a time")) << said;
  EXPECT_GT(hal.dropped(), 0U);
  EXPECT_TRUE(cycleUntil(Status::kOk));
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
