// One drive in the cycle, frame by frame, in a time of its own.
#include "canopen/drive.h"

#include <gtest/gtest.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::canopen {
namespace {

struct DriveTest : testing::Test {
  Settings settings = made();
  PdoLayout layout = laid();
  Drive drive{settings, 0, layout, 0};
  std::int64_t now = 0;

  static Settings made() {
    Settings settings;
    settings.period_ns = link::kMillisecond;
    settings.heartbeat_timeout_ns = 100 * link::kMillisecond;
    settings.enable_timeout_ns = link::kSecond;
    settings.missed_pdos = 3;
    DriveSettings drive;
    drive.joint = "elbow";
    drive.node = 1;
    drive.counts = drive.velocity_scale = 1000;
    drive.most_effort = 10;
    settings.drives.push_back(drive);
    return settings;
  }

  static PdoLayout laid() {
    PdoLayout layout{};
    layout.receive[0] = {0x201, 6};
    layout.transmit[0] = {0x181, 6};
    layout.control_word = {0, 0, 2};
    layout.target_position = {0, 2, 4};
    layout.status_word = {0, 0, 2};
    layout.position = {0, 2, 4};
    return layout;
  }

  // A cycle in which the drive says this of itself, and is told something.
  std::array<Alarm, 3> cycle(std::uint16_t status_word, std::int32_t position, const Reference* reference = nullptr,
                             bool robot_is_led = true) {
    Frame frame = frameOf(0x181, {});
    frame.can_dlc = 6;
    put(frame, 0, 2, status_word);
    put(frame, 2, 4, static_cast<std::uint32_t>(position));
    drive.heardState(0, frame);
    drive.heardHeartbeat(5, now);
    return silent(reference, robot_is_led);
  }
  std::array<Alarm, 3> silent(const Reference* reference = nullptr, bool robot_is_led = true) {
    now += link::kMillisecond;
    const auto alarms = drive.look(now, true);
    drive.command(reference, robot_is_led);
    return alarms;
  }
  void enable() {
    for (const int word : {0x0250, 0x0231, 0x0233, 0x0237}) cycle(static_cast<std::uint16_t>(word), 0);
  }
  std::uint32_t controlWord() const { return get(drive.frames().front(), 0, 2); }
  std::int32_t target() const { return static_cast<std::int32_t>(get(drive.frames().front(), 2, 4)); }
};

TEST_F(DriveTest, is_led_to_enabled_and_holds_until_the_robot_can_be_led) {
  const Reference reference{1.5, 0, 0, 0, 0, link::kPosition};
  cycle(0x0250, 100, &reference);
  EXPECT_EQ(controlWord(), kShutDown);
  cycle(0x0231, 101, &reference);
  EXPECT_EQ(controlWord(), kSwitchOn);
  EXPECT_EQ(target(), 101);
  cycle(0x0233, 102, &reference);
  EXPECT_EQ(controlWord(), kEnable);
  EXPECT_EQ(cycle(0x0237, 103, &reference, false)[2].cause, Cause::kEnabled);
  cycle(0x0237, 90, &reference, false);
  EXPECT_EQ(target(), 103);
  cycle(0x0237, 103, &reference, true);
  EXPECT_EQ(target(), 1500);
  cycle(0x0237, 500, &reference, false);  // another one fell: it goes on with the robot, which brakes
  EXPECT_EQ(target(), 1500);
}

// In the very cycle in which it is seen, whatever else there is to tell.
TEST_F(DriveTest, a_fault_that_comes_with_its_emergency_is_never_reset_without_being_asked) {
  enable();
  for (int i = 0; i < 40; ++i) {
    drive.heardEmergency(frameOf(0x81, {static_cast<std::uint8_t>(0x10 + i), 0x32}));
    const auto alarms = cycle(0x0218, 0);
    EXPECT_EQ(alarms[0].cause, Cause::kEmergency);
    EXPECT_EQ(alarms[2].cause, i == 0 ? Cause::kFault : Cause::kNone);
    EXPECT_TRUE(drive.hasFallen());
    EXPECT_EQ(controlWord(), kDisableVoltage);
  }
  drive.retry();
  bool was_reset = false;
  for (int i = 0; i < 40; ++i) {
    cycle(0x0218, 0);
    was_reset = was_reset || controlWord() == kResetFault;
  }
  EXPECT_TRUE(was_reset);
}

TEST_F(DriveTest, what_is_missing_is_told_once_and_so_is_its_return) {
  enable();
  EXPECT_EQ(silent()[1].cause, Cause::kNone);
  EXPECT_EQ(silent()[1].cause, Cause::kNone);
  EXPECT_TRUE(drive.isReady());
  EXPECT_EQ(silent()[1].cause, Cause::kNoState);
  EXPECT_FALSE(drive.isReady());
  EXPECT_EQ(silent()[1].cause, Cause::kNone);
  EXPECT_EQ(cycle(0x0237, 0)[1].cause, Cause::kIsBack);
  EXPECT_TRUE(drive.isReady());
  EXPECT_EQ(drive.lostStates(), 4U);
}

TEST_F(DriveTest, targets_beyond_32_bits_do_not_wrap) {
  enable();
  const Reference far{1e12, 0, 0, 0, 0, link::kPosition};
  cycle(0x0237, 0, &far);
  EXPECT_EQ(target(), 2'147'483'647);
}

TEST_F(DriveTest, a_state_that_is_cut_is_none) {
  Frame frame = frameOf(0x181, {0x37, 0x02, 1});
  drive.heardState(0, frame);
  EXPECT_EQ(drive.state(), DriveState::kNotReady);
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
