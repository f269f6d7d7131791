#include "joint_limits.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "rig.h"

namespace robotui::rt::hal {
namespace {

using link::Objection;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Sound, is_every_number_that_the_mode_means_and_no_other_is_looked_at) {
  EXPECT_EQ(objectionTo(position(1)), Objection::kNone);
  link::JointCommand other = position(1);
  other.effort = kNaN;
  EXPECT_EQ(objectionTo(other), Objection::kNone);
  EXPECT_EQ(objectionTo(position(kNaN)), Objection::kNoNumber);
  EXPECT_EQ(objectionTo(velocity(kInfinity)), Objection::kNoNumber);
  EXPECT_EQ(objectionTo(effort(-kInfinity)), Objection::kNoNumber);
}

TEST(Sound, gains_are_not_negative_and_modes_are_known) {
  link::JointCommand command = position(0);
  command.mode |= link::kStiffness;
  command.stiffness = -1;
  EXPECT_EQ(objectionTo(command), Objection::kBadGain);
  command = position(0);
  command.mode |= 0x20;
  EXPECT_EQ(objectionTo(command), Objection::kUnknownMode);
}

struct JointLimits : testing::Test {
  Limits limits{robotOf(1).joints[0], 0.001};
  Reference last{0, 0, 0, 0, 0, link::kPosition};

  bool apply(Reference& wanted) const {
    const bool is_beyond = limits.applyAtOnce(wanted);
    return limits.applyStep(wanted, last) || is_beyond;
  }
};

TEST_F(JointLimits, a_position_moves_by_the_velocity_limit_at_most) {
  Reference wanted{1, 0, 0, 0, 0, link::kPosition};
  EXPECT_TRUE(apply(wanted));
  EXPECT_DOUBLE_EQ(wanted.position, 0.001);
  wanted.position = 0.0005;
  EXPECT_FALSE(apply(wanted));
}

TEST_F(JointLimits, a_joint_outside_its_limits_goes_in_slowly) {
  last.position = 3;
  Reference wanted{0, 0, 0, 0, 0, link::kPosition};
  EXPECT_TRUE(apply(wanted));
  EXPECT_DOUBLE_EQ(wanted.position, 2.999);
}

TEST_F(JointLimits, a_velocity_is_cut_and_rises_in_a_tenth_of_a_second) {
  Reference wanted{0, 5, 0, 0, 0, link::kVelocity};
  EXPECT_TRUE(apply(wanted));
  EXPECT_DOUBLE_EQ(wanted.velocity, 0.01);
  last.velocity = 1;
  wanted.velocity = 5;
  apply(wanted);
  EXPECT_DOUBLE_EQ(wanted.velocity, 1);
}

TEST_F(JointLimits, an_effort_is_cut) {
  Reference wanted{0, 0, -80, 0, 0, link::kEffort};
  EXPECT_TRUE(apply(wanted));
  EXPECT_DOUBLE_EQ(wanted.effort, -50);
}

TEST(Unlimited, joints_are_cut_nowhere) {
  const Limits limits({1, "wheel", config::JointType::kRevolute, -kInfinity, kInfinity, kInfinity, kInfinity}, 0.001);
  Reference wanted{1e6, 0, 0, 0, 0, link::kPosition};
  EXPECT_FALSE(limits.applyAtOnce(wanted));
  EXPECT_FALSE(limits.applyStep(wanted, {}));
  EXPECT_EQ(wanted.position, 1e6);
}

}  // namespace
}  // namespace robotui::rt::hal
