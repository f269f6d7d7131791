// Simulated time that stands, goes back, goes slowly, or comes in disorder.
#include "rig.h"

namespace robotui::rt::hal::gazebo {
namespace {

TEST_F(GazeboTest, a_paused_world_is_told_and_joints_are_away) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  world->say("pause");
  EXPECT_TRUE(cycleUntil(Status::kTimeout));
  EXPECT_TRUE(cycleUntilSaid("The world 'default' is paused at ")) << said;
  world->say("run");
  EXPECT_TRUE(cycleUntil(Status::kOk));
  EXPECT_TRUE(cycleUntilSaid("The world 'default' runs.")) << said;
}

TEST_F(GazeboTest, a_world_that_stands_from_the_beginning_is_opened) {
  begin({"paused"});
  open();
  EXPECT_TRUE(cycleUntilSaid("is paused at 0.00 s")) << said;
  EXPECT_TRUE(cycleUntil(Status::kTimeout));
  world->say("run");
  EXPECT_TRUE(cycleUntil(Status::kOk));
}

// Long enough for the cycle around it to make all joints safe.
TEST_F(GazeboTest, a_reset_is_a_silence_of_some_cycles) {
  begin();
  open();
  tell({0.4, 0, 0, 0, 0, link::kPosition});
  ASSERT_TRUE(cycleUntil([&](Status) { return std::abs(joints[0].link_position - 0.4) < 0.01; }));
  world->say("reset");
  int silent = 0;
  EXPECT_TRUE(cycleUntil([&](Status status) {
    silent += status == Status::kTimeout ? 1 : 0;
    return silent > 0 && status == Status::kOk;
  }));
  EXPECT_GE(silent, kMisses);
  EXPECT_TRUE(cycleUntilSaid("Simulated time went back")) << said;
}

TEST_F(GazeboTest, a_slow_world_is_told) {
  begin();
  open();
  world->say("slow 0.25");
  EXPECT_TRUE(cycleUntilSaid("runs at 0.25 of real time")) << said;
  EXPECT_TRUE(cycleUntil(Status::kOk));
  world->say("slow 1");
  EXPECT_TRUE(cycleUntilSaid("nearly as fast as real time again")) << said;
}

TEST_F(GazeboTest, states_out_of_order_are_dropped) {
  begin();
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk));
  world->say("late");
  tell({0, 0.3, 0, 0, 0, link::kVelocity});
  double last = joints[0].link_position;
  bool backwards = false;
  EXPECT_TRUE(cycleUntil([&](Status) {
    backwards = backwards || joints[0].link_position < last - 1e-12;
    last = joints[0].link_position;
    return hal.dropped() > 20 && last > 0.1;
  }));
  EXPECT_FALSE(backwards);
  EXPECT_EQ(said.find("went back"), std::string::npos) << said;
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
