// What is left behind when the control ends.
#include "rig.h"

namespace robotui::rt::hal::gazebo {
namespace {

struct GazeboEnd : GazeboTest {
  // A robot whose joints turn when the control ends.
  void end(const std::string& how) {
    begin();
    open(", at_end: " + how);
    tell({0, 0.3, 0, 0, 0, link::kVelocity});
    ASSERT_TRUE(cycleUntil([&](Status) { return joints[1].link_velocity > 0.25; }));
    ASSERT_EQ(world->say("listeners"), "some");
    hal.close();
  }

  bool eventually(const std::function<bool()>& condition) {
    for (int i = 0; i < 500; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  char way() { return world->say("joint elbow").front(); }
};

TEST_F(GazeboEnd, joints_hold_where_they_are_and_nobody_listens) {
  end("hold");
  EXPECT_TRUE(eventually([&] { return way() == 'p'; })) << world->say("joint elbow");
  EXPECT_TRUE(eventually([&] { return world->say("listeners") == "none"; }));
  EXPECT_EQ(world->say("paused"), "no");
}

TEST_F(GazeboEnd, the_world_is_paused) {
  end("pause");
  EXPECT_TRUE(eventually([&] { return world->say("paused") == "yes"; }));
}

TEST_F(GazeboEnd, joints_are_left_as_they_were_told) {
  end("leave");
  EXPECT_TRUE(eventually([&] { return world->say("listeners") == "none"; }));
  EXPECT_EQ(way(), 'v');
  EXPECT_EQ(world->say("joint elbow").substr(0, 5), "v 0.3");
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
