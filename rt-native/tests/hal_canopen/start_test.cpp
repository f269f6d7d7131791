// What is wrong at the start is said with the drive, the cause and the remedy.
#include "world.h"

namespace robotui::rt::hal::canopen {
namespace {

struct CanOpenStart : CanOpenTest {
  std::string refusal(const std::string& more = "", const std::string& drive = "") {
    try {
      open(more, drive);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "nothing";
  }
  void expect(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
};

TEST_F(CanOpenStart, a_drive_that_is_silent) {
  world.with(1, [](simulated::Drive& drive) { drive.ailments().is_silent = true; });
  const std::string said = refusal(", sdo_timeout_ms: 200");
  expect(said, "The drive of 'joint_2' (node 2) cannot be made ready: it does not answer to 0x1000:0");
  expect(said, "terminators");
}

TEST_F(CanOpenStart, a_node_that_is_no_drive) {
  world.with(0, [](simulated::Drive& drive) { drive.dictionary().set(kDeviceType, 401); });
  expect(refusal(), "(node 1) cannot be made ready: it is no drive of CiA 402 but of profile 401");
}

TEST_F(CanOpenStart, an_object_that_the_drive_refuses) {
  expect(refusal("", ", objects: [[0x2001, 3, u16, 7]]"), "it refuses 0x2001:3: it has no such object, 0x06020000");
  expect(refusal("", ", objects: [[0x1000, 0, u32, 7]]"), "it refuses 0x1000:0: it can only be read");
}

TEST_F(CanOpenStart, a_kept_mapping_that_lacks_what_is_needed) {
  expect(refusal(", mapping: keep, modes: [position, velocity]"),
         "none of its RPDOs carries 0x60FF:0: map it there, or write mapping: write");
}

TEST_F(CanOpenStart, a_drive_without_a_consumer_of_heartbeats_is_told) {
  world.with(0, [](simulated::Drive& drive) { drive.dictionary().remove(kHeartbeatConsumer); });
  open();
  ASSERT_TRUE(cycleUntil(Status::kOk)) << all();
  EXPECT_TRUE(isTold("(node 1) cannot watch the heartbeat of the control")) << all();
}

TEST_F(CanOpenStart, more_frames_than_the_bus_can_carry) {
  expect(refusal(", bitrate: 125000"),
         "7 frames in each cycle need up to 7560 us of the bus at 125000 bit/s, and the "
         "period is 2000 us: write a longer period_us");
}

TEST_F(CanOpenStart, no_bus) {
  config::HalConfig config;
  config.params = YAML::Load(
      "{interface: 'unix:/nowhere', drives: {joint_1: {node: 1, counts_per_radian: 1}, joint_2: "
      "{node: 2, counts_per_radian: 1}}}");
  try {
    hal.open(robot, config, link::kMillisecond);
    FAIL();
  } catch (const std::runtime_error& error) {
    expect(error.what(), "Nothing simulates a CAN bus at /nowhere");
    expect(error.what(), "robotui-rt-drives");
  }
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
