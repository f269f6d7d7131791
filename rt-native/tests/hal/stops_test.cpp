// Emergency stops in the cycle: pressed or unknown, all joints are safe at once; released, nothing moves by itself.
#include "cycle.h"

#include <gtest/gtest.h>

#include "rig.h"
#include "robotui/rt/link/allocations.h"

namespace robotui::rt::hal {
namespace {

using link::Control;
using link::FallCause;

struct StopsTest : testing::Test, Rig {
  StopsTest() {
    settings.emergency_stops = 2;
    hardware.stops = {StopInput::kReleased, StopInput::kReleased};
    cycle.emplace(robot, settings, hardware, *board, inbox, torque, *state);
    run();
    grantAll();
    goOn(3);
  }
  void goOn(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      command(velocity(0.5));
      run();
    }
  }
  std::vector<link::JointEvent> told() {
    std::vector<link::JointEvent> events;
    for (link::JointEvent event; cycle->takeEvent(event);) events.push_back(event);
    return events;
  }
  Control controlOf(std::size_t joint) {
    run();
    return static_cast<Control>(frame().joints[joint].control);
  }
};

TEST_F(StopsTest, one_that_is_pressed_makes_all_joints_safe_in_the_same_cycle) {
  ASSERT_GT(hardware.sent[0].velocity, 0);
  const double before = hardware.sent[0].velocity;
  hardware.stops[1] = StopInput::kPressed;
  goOn(1);
  for (const Reference& reference : hardware.sent) EXPECT_LT(reference.velocity, before);
  const auto events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].cause, FallCause::kEmergency);
  EXPECT_EQ(events[0].stops, (link::StopBits{2, 0}));
  EXPECT_EQ(events[0].cycle, number);
  EXPECT_EQ(events[0].joints.count(), 3U);
  for (std::size_t joint = 0; joint < 3; ++joint) EXPECT_EQ(controlOf(joint), Control::kSafe);
  EXPECT_EQ(frame().hal_status, static_cast<std::uint32_t>(Status::kEmergencyStop));
}

TEST_F(StopsTest, nothing_moves_by_itself_when_it_is_released) {
  hardware.stops[0] = StopInput::kPressed;
  goOn(200);
  hardware.position = 0.25;  // without power it sank
  hardware.stops[0] = StopInput::kReleased;
  goOn(100);
  EXPECT_EQ(controlOf(0), Control::kSafe);
  EXPECT_EQ(hardware.sent[0].velocity, 0);
  EXPECT_EQ(hardware.sent[0].position, 0.25);
  EXPECT_EQ(frame().hal_status, static_cast<std::uint32_t>(Status::kOk));
  told();
  grantAll();
  goOn(2);
  EXPECT_EQ(controlOf(0), Control::kCommanded);
  EXPECT_TRUE(told().empty());
}

TEST_F(StopsTest, one_that_cannot_be_read_counts_as_pressed) {
  hardware.stops[0] = StopInput::kUnread;
  goOn(1);
  EXPECT_EQ(controlOf(0), Control::kSafe);
  EXPECT_EQ(cycle->takeStops().bits, (link::StopBits{0, 1}));
  hardware.status = Status::kTimeout;
  goOn(1);
  EXPECT_EQ(frame().hal_status, static_cast<std::uint32_t>(Status::kTimeout)) << "that explains it";
}

TEST_F(StopsTest, a_plugin_that_is_started_while_it_is_pressed_leads_nothing) {
  hardware.stops[0] = StopInput::kPressed;
  goOn(1);
  told();
  grantAll();
  goOn(1);
  const auto events = told();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].grant, 2U);
  EXPECT_EQ(controlOf(0), Control::kSafe);
}

TEST_F(StopsTest, a_press_that_is_short_is_told) {
  EXPECT_FALSE(cycle->takeStops().bits.any());
  hardware.stops[0] = StopInput::kPressed;
  goOn(1);
  hardware.stops[0] = StopInput::kReleased;
  goOn(5);
  const StopReport report = cycle->takeStops();
  EXPECT_EQ(report.bits, (link::StopBits{1, 0}));
  EXPECT_EQ(report.cycle, number - 5);
  EXPECT_FALSE(cycle->takeStops().bits.any());
}

TEST_F(StopsTest, a_hal_that_does_not_read_them_keeps_the_robot_safe_and_is_told_after_a_second) {
  hardware.stops = {};
  number = 0;
  cycle.emplace(robot, settings, hardware, *board, inbox, torque, *state);
  goOn(900);
  EXPECT_EQ(controlOf(0), Control::kSafe);
  EXPECT_FALSE(cycle->takeStops().bits.any());
  goOn(200);
  EXPECT_EQ(cycle->takeStops().bits, (link::StopBits{0, 3}));
}

TEST_F(StopsTest, nothing_of_it_allocates) {
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    hardware.stops[1] = StopInput::kPressed;
    goOn(5);
    hardware.stops[1] = StopInput::kReleased;
    goOn(5);
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

}  // namespace
}  // namespace robotui::rt::hal
