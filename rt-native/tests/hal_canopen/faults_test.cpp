// What goes wrong on a bus is told, makes the joints safe, and can be brought back.
#include <linux/can/error.h>

#include "world.h"

namespace robotui::rt::hal::canopen {
namespace {

TEST_F(CanOpenTest, a_fault_is_told_with_its_text_and_is_reset_by_hand_alone) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) { drive.fail(0x3210); });
  ASSERT_TRUE(cycleUntil(Status::kFault)) << all();
  EXPECT_TRUE(cycleUntil([&] { return isTold("'joint_1' (node 1) reports the error 0x3210 (DC link over-voltage)"); }))
      << all();
  EXPECT_TRUE(cycleUntil([&] { return isTold("it is in 'fault'") && isTold("robotui-rt-ctl recover"); })) << all();
  EXPECT_EQ(joints[0].fault & 0xffffU, 0x3210U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(cycle(), Status::kFault);  // it does not begin to move by itself
  EXPECT_EQ(world.with(0, [](simulated::Drive& drive) { return drive.motor().state(); }), DriveState::kFault);
  EXPECT_NE(hal.recover().front().find("'joint_1' (node 1) is asked to be enabled again"), std::string::npos);
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_EQ(joints[0].fault, 0U);
}

TEST_F(CanOpenTest, the_others_hold_while_one_has_a_fault) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) { drive.fail(0x8611); });
  ASSERT_TRUE(cycleUntil(Status::kFault)) << all();
  EXPECT_EQ(world.with(1, [](simulated::Drive& drive) { return drive.motor().state(); }), DriveState::kEnabled);
}

// What was referred to before a fault is not where the joint is: it may have been moved by hand meanwhile.
TEST_F(CanOpenTest, a_drive_that_comes_back_stays_where_it_is) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) {
    drive.fail(0x7305);
    drive.motor() = simulated::Motor(5000);
    drive.motor().fail();
  });
  ASSERT_TRUE(cycleUntil(Status::kFault)) << all();
  hal.recover();
  bool leapt = false;
  ASSERT_TRUE(cycleUntil([&] {
    const double position = world.with(0, [](simulated::Drive& drive) { return drive.motor().position(); });
    leapt = leapt || std::abs(position - 5000) > 1;
    return joints[0].fault == 0;
  })) << all();
  EXPECT_FALSE(leapt);
}

TEST_F(CanOpenTest, a_drive_that_does_not_get_enabled_is_told_with_its_state) {
  world.with(1, [](simulated::Drive& drive) { drive.motor().block(true); });
  open(", enable_timeout_ms: 100");
  ASSERT_TRUE(cycleUntil(Status::kFault)) << all();
  EXPECT_TRUE(cycleUntil([&] {
    return isTold(
        "'joint_2' (node 2) does not reach 'operation enabled' within 100 ms: it stays in 'switch on "
        "disabled'; look at the motor supply, at STO");
  })) << all();
  world.with(1, [](simulated::Drive& drive) { drive.motor().block(false); });
  hal.recover();
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
}

TEST_F(CanOpenTest, a_heartbeat_that_ends_is_a_time_out_and_one_that_returns_is_enough) {
  open(", heartbeat_ms: 20, heartbeat_timeout_ms: 500");
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) { drive.ailments().sends_no_heartbeat = true; });
  ASSERT_TRUE(cycleUntil(Status::kTimeout)) << all();
  EXPECT_TRUE(cycleUntil([&] { return isTold("'joint_1' (node 1) sent no heartbeat for 500 ms"); })) << all();
  EXPECT_NE(joints[0].fault, 0U);
  world.with(0, [](simulated::Drive& drive) { drive.ailments().sends_no_heartbeat = false; });
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
}

TEST_F(CanOpenTest, states_that_do_not_come_are_a_time_out) {
  open(", missed_pdos: 50");
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(1, [](simulated::Drive& drive) { drive.ailments().sends_no_state = true; });
  EXPECT_TRUE(cycleUntil([&] { return isTold("'joint_2' (node 2) sent no state (PDO) in 50 cycles"); })) << all();
  EXPECT_EQ(cycle(), Status::kTimeout);
  world.with(1, [](simulated::Drive& drive) { drive.ailments().sends_no_state = false; });
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_TRUE(isTold("that did not come in their cycle")) << all();
}

TEST_F(CanOpenTest, emergency_stops_are_digital_inputs_of_a_drive_and_unknown_with_it) {
  stops = {{"pendant", "joint_2", 16, true, {}}, {"mat", "joint_2", 17, false, {}}};
  world.with(1, [](simulated::Drive& drive) { drive.dictionary().set(kDigitalInputs, 0x1'0000); });
  open(", missed_pdos: 50");
  std::array<StopInput, 2> said{};
  const auto say = [&](StopInput pendant, StopInput mat) {
    return cycleUntil([&] {
      said.fill(StopInput::kUnread);
      hal.senseStops(said);
      return said[0] == pendant && said[1] == mat;
    });
  };
  ASSERT_TRUE(say(StopInput::kReleased, StopInput::kReleased)) << all();
  world.with(1, [](simulated::Drive& drive) { drive.dictionary().set(kDigitalInputs, 0x2'0000); });
  EXPECT_TRUE(say(StopInput::kPressed, StopInput::kPressed)) << all();
  world.with(1, [](simulated::Drive& drive) { drive.ailments().is_silent = true; });
  EXPECT_TRUE(say(StopInput::kUnread, StopInput::kUnread)) << all();
}

TEST_F(CanOpenTest, a_drive_that_restarts_is_configured_anew) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) { drive.restart(); });
  ASSERT_TRUE(cycleUntil(Status::kFault)) << all();
  EXPECT_TRUE(cycleUntil([&] { return isTold("'joint_1' (node 1) has started anew"); })) << all();
  hal.recover();
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_EQ(world.with(0, [](simulated::Drive& drive) { return drive.dictionary().get(kHeartbeatProducer); }), 100U);
}

TEST_F(CanOpenTest, nothing_to_recover_is_said) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_EQ(hal.recover(), std::vector<std::string>{"No drive waits to be enabled again."});
}

TEST_F(CanOpenTest, a_user_disables_the_drives_and_enables_them_again) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_TRUE(stands(DrivePhase::kEnabled, "operation enabled"));
  EXPECT_NE(hal.enable(true).front().find("No drive is disabled"), std::string::npos);
  hal.enable(false);
  ASSERT_TRUE(cycleUntil([&] { return stands(DrivePhase::kDisabled, "switch on disabled"); })) << all();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(cycle(), Status::kTimeout);  // it does not come back by itself
  EXPECT_EQ(world.with(0, [](simulated::Drive& drive) { return drive.motor().state(); }),
            DriveState::kSwitchOnDisabled);
  EXPECT_EQ(hal.recover(), std::vector<std::string>{"No drive waits to be enabled again."});
  EXPECT_EQ(hal.enable(true).size(), 2U);
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
}

TEST_F(CanOpenTest, drives_that_are_looked_at_alone_are_enabled_by_a_user) {
  open(", enable: false");
  ASSERT_TRUE(cycleUntil([&] { return stands(DrivePhase::kDisabled, "switch on disabled"); })) << all();
  hal.enable(true);
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
}

TEST_F(CanOpenTest, a_fault_is_neither_enabled_nor_disabled) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) { drive.fail(0x3210); });
  ASSERT_TRUE(cycleUntil([&] { return stands(DrivePhase::kFault, "0x3210 (DC link over-voltage)"); })) << all();
  hal.enable(false);
  ASSERT_TRUE(cycleUntil([&] { return hal.drives().back().phase == DrivePhase::kDisabled; })) << all();
  EXPECT_TRUE(stands(DrivePhase::kFault, "0x3210 (DC link over-voltage)"));
  EXPECT_EQ(hal.enable(true).size(), 1U);
  EXPECT_EQ(hal.recover().size(), 1U);
  EXPECT_TRUE(cycleUntil(Status::kOk)) << all();
}

TEST_F(CanOpenTest, a_bus_that_is_off_is_a_fault_until_it_restarts) {
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  world.with(0, [](simulated::Drive& drive) { drive.ailments().is_silent = true; });
  world.with(1, [](simulated::Drive& drive) { drive.ailments().is_silent = true; });
  const auto error = [&](canid_t what) {
    world.with([&](simulated::SimulatedBus& bus) { bus.send(frameOf(CAN_ERR_FLAG | what, {0, 0, 0, 0, 0, 0, 0, 0})); });
  };
  error(CAN_ERR_BUSOFF);
  ASSERT_TRUE(cycleUntil(Status::kFault)) << all();
  EXPECT_TRUE(cycleUntil([&] { return isTold("is off: the controller gave up") && isTold("type can restart"); }))
      << all();
  error(CAN_ERR_RESTARTED);
  EXPECT_TRUE(cycleUntil([&] { return isTold("works again"); })) << all();
}

TEST_F(CanOpenTest, a_bus_that_goes_away_is_a_fault) {
  auto own = std::make_unique<World>(2);
  const std::string interface = own->interface();
  open(", bitrate: 1000000");
  ASSERT_TRUE(cycleUntil(Status::kOk));
  CanOpen other;
  config::HalConfig config;
  config.params = YAML::Load("{interface: '" + interface +
                             "', drives: {joint_1: {node: 1, counts_per_radian: 1e4}, joint_2: {node: 2, "
                             "counts_per_radian: 1e4}}}");
  other.open(robot, config, 2 * link::kMillisecond);
  own.reset();
  EXPECT_EQ(other.sense(measured), Status::kFault);
  const auto news = other.news();
  ASSERT_FALSE(news.empty());
  EXPECT_NE(news.front().find("is down"), std::string::npos) << news.front();
  other.close();
}

// The drives are gone with their control: they stop by themselves.
TEST_F(CanOpenTest, a_drive_whose_control_falls_silent_stops) {
  open(", heartbeat_ms: 20, heartbeat_timeout_ms: 2000");
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  const auto state = [&] { return world.with(0, [](simulated::Drive& drive) { return drive.motor().state(); }); };
  for (int i = 0; i < 20'000 && state() == DriveState::kEnabled; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(state(), DriveState::kFault);
  ASSERT_TRUE(cycleUntil(Status::kFault));
  EXPECT_TRUE(cycleUntil([&] { return isTold("0x8130 (it missed the heartbeat of the control)"); })) << all();
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
