// Groups of plugins in the cycle: all of it is switched in one cycle, or nothing is, whatever the board says meanwhile.
#include "group_switch.h"

#include <gtest/gtest.h>

#include "rig.h"

namespace robotui::rt::hal {
namespace {

using link::Control;
using link::GroupRefusal;
using link::PluginState;

// Plugin 0 leads all joints and is to be followed by plugin 2, of another host.
struct GroupSwitchTest : testing::Test, Rig {
  GroupSwitchTest() {
    run();
    grantAll(0);
    goOn(5);
  }

  // Both threads go on, and both plugins command what they would.
  void goOn(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      ++host->thread_statistics[0].cycles;
      ++second_host->thread_statistics[0].cycles;
      command(position(0.001), 0);
      command(position(0.002), 2);
      run();
    }
  }

  link::GroupOrder swap(std::uint64_t in, std::uint64_t every = 1) const {
    link::GroupOrder order{7, number + in, every, number + in + 20, {}, {}, {}, {}};
    order.stop.set(0);
    order.start.set(2);
    for (std::uint32_t j = 0; j < kJoints; ++j) {
      order.joints.set(j);
      order.owners.at(j) = 2;
    }
    return order;
  }

  void bothAreReady() {
    host->plugins[0].state = static_cast<std::uint32_t>(PluginState::kStopping);
    second_host->plugins[2].state = static_cast<std::uint32_t>(PluginState::kStarting);
  }

  std::optional<link::GroupOutcome> outcome() {
    link::GroupOutcome told;
    return cycle->groups().take(told) ? std::optional(told) : std::nullopt;
  }

  void expectLeader(std::uint16_t plugin) {
    const auto now = frame();
    for (std::uint32_t j = 0; j < kJoints; ++j) {
      EXPECT_EQ(now.joints[j].owner, plugin) << "in cycle " << now.cycle;
      EXPECT_EQ(now.joints[j].control, static_cast<std::uint8_t>(Control::kCommanded)) << "in cycle " << now.cycle;
    }
  }
};

TEST_F(GroupSwitchTest, GivesJointsFromOnePluginToAnotherWithoutACycleInBetween) {
  cycle->groups().order(swap(4));
  bothAreReady();
  for (int i = 0; i < 3; ++i) {
    goOn(1);
    expectLeader(0);
    EXPECT_EQ(frame().switched, 0u);
  }
  goOn(1);
  EXPECT_EQ(frame().switched, 7u);
  EXPECT_EQ(frame().joints[0].owner, 2);
  EXPECT_NEAR(hardware.sent[0].position, 0.001, 1e-9);  // as fast as the joint may go to what the other one wants
  const auto told = outcome();
  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->refusal, GroupRefusal::kNone);
  EXPECT_EQ(told->cycle, number);
  goOn(1);
  expectLeader(2);
  EXPECT_EQ(frame().joints[0].rejected, 0u);
}

// The board is written by a thread that is not real time: whatever it has done so far, the HAL knows better.
TEST_F(GroupSwitchTest, LeadsByTheNewOwnerWhileTheBoardFollows) {
  cycle->groups().order(swap(3));
  bothAreReady();
  goOn(5);
  expectLeader(2);
  grants.release(0);
  goOn(2);
  expectLeader(2);
  grantAll(2);
  goOn(2);
  expectLeader(2);
  grantAll(0);
  goOn(2);
  expectLeader(0);
}

TEST_F(GroupSwitchTest, ReleasesJointsThatNobodyTakes) {
  auto order = swap(3);
  order.start.reset();
  order.owners.fill(link::kNobody);
  cycle->groups().order(order);
  bothAreReady();
  goOn(4);
  EXPECT_EQ(frame().joints[1].owner, link::kNobody);
  for (std::uint32_t j = 0; j < kJoints; ++j) grants.release(j);
  goOn(1);
  grantAll(2);
  goOn(2);
  expectLeader(2);
}

TEST_F(GroupSwitchTest, SwitchesNothingWhereOneIsNotReadyAndNamesIt) {
  cycle->groups().order(swap(3));
  host->plugins[0].state = static_cast<std::uint32_t>(PluginState::kStopping);
  goOn(30);
  expectLeader(0);
  const auto told = outcome();
  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->refusal, GroupRefusal::kNotReady);
  EXPECT_TRUE(told->lacking.test(2));
  EXPECT_EQ(told->lacking.count(), 1u);
}

// Its memory still says that it is ready.
TEST_F(GroupSwitchTest, DoesNotBelieveAProcessThatIsGone) {
  bothAreReady();
  cycle->groups().order(swap(10));
  goOn(3);
  for (int i = 0; i < 40; ++i) {
    ++host->thread_statistics[0].cycles;
    command(position(0.001), 0);
    run();
  }
  expectLeader(0);
  const auto told = outcome();
  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->refusal, GroupRefusal::kNotReady);
  EXPECT_TRUE(told->lacking.test(2));
}

TEST_F(GroupSwitchTest, WaitsForACycleInWhichAllThreadsAreDue) {
  auto order = swap(10 - number % 10, 10);
  order.until += 100;
  cycle->groups().order(order);
  while (number < order.cycle) goOn(1);
  bothAreReady();
  goOn(9);
  EXPECT_FALSE(outcome().has_value());
  expectLeader(0);
  goOn(1);
  EXPECT_EQ(frame().joints[0].owner, 2);
  EXPECT_EQ(outcome()->cycle, order.cycle + 10);
}

TEST_F(GroupSwitchTest, IsGivenUpWhenTheSupervisorSaysSo) {
  cycle->groups().order(swap(5));
  bothAreReady();
  goOn(2);
  cycle->groups().cancel(7);
  goOn(10);
  expectLeader(0);
  EXPECT_EQ(outcome()->refusal, GroupRefusal::kCancelled);
  cycle->groups().cancel(7);
  goOn(2);
  EXPECT_FALSE(outcome().has_value());
}

TEST_F(GroupSwitchTest, StartsNothingWhileTheHardwareIsAway) {
  cycle->groups().order(swap(5));
  bothAreReady();
  hardware.status = Status::kTimeout;
  goOn(4);
  EXPECT_EQ(outcome()->refusal, GroupRefusal::kSafe);
}

TEST(GroupOrder, IsReadAsItWasWritten) {
  link::GroupOrder order{3, 1200, 4, 2200, {}, {}, {}, {}};
  order.start.set(5);
  order.stop.set(2);
  order.joints.set(1);
  order.owners.at(1) = 5;
  order.joints.set(9);
  order.owners.at(9) = link::kNobody;
  const std::string text = link::textOf(order);
  const auto read = link::groupOrderOf(text.substr(text.find(' ') + 1));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(link::textOf(*read), text);
  for (const char* wrong :
       {"", "0 1 1 1 0 0", "1 1 0 1 0 0", "1 2 3 4 5 6", "1 1 1 1 0 0 128=1", "1 1 1 1 0 0 1:2", "1 1 1 1 0 0 x"})
    EXPECT_FALSE(link::groupOrderOf(wrong).has_value()) << wrong;
  EXPECT_FALSE(link::groupOutcomeOf("1 9 1 0").has_value());
  EXPECT_EQ(link::groupOutcomeOf("1 1 17 100")->cycle, 17u);
}

}  // namespace
}  // namespace robotui::rt::hal
