#include "canopen/drive_state.h"

#include <gtest/gtest.h>

#include "canopen/emergency.h"
#include "canopen/simulated/motor.h"

namespace robotui::rt::hal::canopen {
namespace {

TEST(DriveStates, status_words_of_drives) {
  EXPECT_EQ(stateOf(0x0000), DriveState::kNotReady);
  EXPECT_EQ(stateOf(0x0250), DriveState::kSwitchOnDisabled);
  EXPECT_EQ(stateOf(0x0231), DriveState::kReadyToSwitchOn);
  EXPECT_EQ(stateOf(0x0233), DriveState::kSwitchedOn);
  EXPECT_EQ(stateOf(0x1637), DriveState::kEnabled);
  EXPECT_EQ(stateOf(0x0217), DriveState::kQuickStop);
  EXPECT_EQ(stateOf(0x021f), DriveState::kFaultReaction);
  EXPECT_EQ(stateOf(0x0218), DriveState::kFault);
}

// From wherever the simulated drive is, the words lead to "operation enabled".
TEST(DriveStates, each_leads_to_enabled) {
  for (const std::uint16_t first : {kDisableVoltage, kShutDown, kSwitchOn, std::uint16_t{0x0002}}) {
    simulated::Motor motor(0);
    motor.control(first);
    for (int i = 0; i < 5; ++i) motor.control(towardsEnabled(stateOf(motor.statusWord()), i % 2 == 1));
    EXPECT_EQ(motor.state(), DriveState::kEnabled) << first;
  }
}

TEST(DriveStates, a_fault_needs_a_rising_edge) {
  simulated::Motor motor(0);
  motor.fail();
  motor.control(towardsEnabled(DriveState::kFault, true));
  EXPECT_EQ(motor.state(), DriveState::kSwitchOnDisabled);
  motor.fail();
  motor.control(kResetFault);
  EXPECT_EQ(motor.state(), DriveState::kFault);
  motor.control(towardsEnabled(DriveState::kFault, false));
  motor.control(towardsEnabled(DriveState::kFault, true));
  EXPECT_EQ(motor.state(), DriveState::kSwitchOnDisabled);
}

TEST(Emergencies, have_texts) {
  EXPECT_EQ(errorText(0x3210), "0x3210 (DC link over-voltage)");
  EXPECT_EQ(errorText(0x3299), "0x3299 (voltage)");
  EXPECT_EQ(errorText(0xff12), "0xFF12 (of the maker of the drive: see its manual)");
  EXPECT_EQ(errorText(0xf012), "0xF012 (additional functions)");
  EXPECT_EQ(errorText(0x0012), "0x0012 (unknown)");
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
