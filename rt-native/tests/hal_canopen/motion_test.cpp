// Joints that are drives follow, in each of their modes.
#include "robotui/rt/link/allocations.h"
#include "world.h"

namespace robotui::rt::hal::canopen {
namespace {

TEST_F(CanOpenTest, drives_are_enabled_and_the_joints_are_where_the_drives_are) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_NEAR(joints[0].link_position, 0.1, 1e-4);
  EXPECT_NEAR(joints[1].link_position, -0.2, 1e-4);  // this drive turns the other way
  EXPECT_TRUE(cycleUntil([&] { return isTold("The drive of 'joint_2' (node 2) is enabled."); })) << all();
  EXPECT_NEAR(world.with(0, [](simulated::Drive& drive) { return drive.motor().position(); }), 1000, 1);
}

TEST_F(CanOpenTest, joints_follow_positions) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  for (Reference& reference : references) reference.position = 0.5;
  EXPECT_TRUE(cycleUntil([&] { return std::abs(joints[0].link_position - 0.5) < 1e-3; }));
  EXPECT_TRUE(cycleUntil([&] { return std::abs(joints[1].link_position - 0.5) < 1e-3; }));
  EXPECT_EQ(joints[0].fault, 0U);
}

TEST_F(CanOpenTest, joints_follow_velocities_and_efforts_where_the_modes_are_wanted) {
  open(", modes: [position, velocity, effort]", ", rated_torque: 20");
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  references[0] = {0, 0.4, 0, 0, 0, link::kVelocity};
  references[1] = {0, 0, 10, 0, 0, link::kEffort};
  EXPECT_TRUE(cycleUntil([&] { return joints[0].link_position > 0.2 && joints[0].link_velocity > 0.2; })) << all();
  EXPECT_TRUE(cycleUntil([&] { return std::abs(joints[1].effort - 10) < 0.1; })) << all();
  references[0] = {joints[0].link_position, 0, 0, 0, 0, link::kPosition};
  EXPECT_TRUE(cycleUntil([&] { return joints[0].link_velocity == 0; }));
}

TEST_F(CanOpenTest, joints_are_shown_and_no_drive_is_enabled_where_that_is_wanted) {
  open(", enable: false, enable_timeout_ms: 10");
  world.with(0, [](simulated::Drive& drive) { drive.motor() = simulated::Motor(3000); });
  EXPECT_TRUE(cycleUntil([&] { return std::abs(joints[0].link_position - 0.3) < 1e-4; }));
  for (int i = 0; i < 30; ++i) EXPECT_EQ(cycle(), Status::kTimeout);
  EXPECT_EQ(world.with(0, [](simulated::Drive& drive) { return drive.motor().state(); }),
            DriveState::kSwitchOnDisabled);
  EXPECT_FALSE(isTold("enabled")) << all();
}

TEST_F(CanOpenTest, a_mode_that_is_not_configured_holds_and_is_told) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  references[0] = {0, 0.4, 0, 0, 0, link::kVelocity};
  EXPECT_TRUE(cycleUntil([&] { return isTold("'joint_1' (node 1) holds its position"); })) << all();
  EXPECT_NEAR(joints[0].link_position, 0.1, 1e-3);
}

TEST_F(CanOpenTest, a_mapping_that_the_drive_has_is_kept_and_velocities_are_found_from_positions) {
  open(", mapping: keep");
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  bool moved = false;
  for (Reference& reference : references) reference.position = 0.4;
  EXPECT_TRUE(cycleUntil([&] {
    moved = moved || joints[0].link_velocity > 0;
    return moved && std::abs(joints[0].link_position - 0.4) < 1e-3;
  }));
}

TEST_F(CanOpenTest, the_drive_knows_limits_period_and_given_objects) {
  open("", ", objects: [[0x6065, 0, u32, 5000]]");
  world.with(0, [](simulated::Drive& drive) {
    EXPECT_EQ(drive.dictionary().get(kLeastPosition), static_cast<std::uint32_t>(-20'000));
    EXPECT_EQ(drive.dictionary().get(kMostPosition), 20'000U);
    EXPECT_EQ(drive.dictionary().get({0x6065}), 5000U);
    EXPECT_EQ(drive.dictionary().get(kInterpolationPeriod), 2U);
    EXPECT_EQ(drive.dictionary().get(kInterpolationExponent), 0xfdU);  // milliseconds
    EXPECT_EQ(drive.dictionary().get(kHeartbeatConsumer), 127U << 16U | 20'000U);
  });
}

TEST_F(CanOpenTest, drives_are_switched_off_at_the_end) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  hal.close();
  is_open = false;
  const auto state = [&] { return world.with(1, [](simulated::Drive& drive) { return drive.motor().state(); }); };
  const auto nmt = [&] { return world.with(1, [](simulated::Drive& drive) { return drive.nmt(); }); };
  for (int i = 0; i < 10'000 && nmt() != NmtState::kPreOperational; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(nmt(), NmtState::kPreOperational);
  EXPECT_EQ(state(), DriveState::kReadyToSwitchOn);
}

TEST_F(CanOpenTest, a_cycle_does_not_allocate) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  const std::uint64_t before = link::allocationCount().calls;
  for (int i = 0; i < 200; ++i) {
    {
      const link::CountAllocations count;
      hal.sense(measured);
      hal.move(references);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
