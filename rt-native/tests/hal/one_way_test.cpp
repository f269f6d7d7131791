#include "one_way.h"

#include <gtest/gtest.h>

namespace robotui::rt::hal {
namespace {

constexpr JointSample kMeasured{0.5, 0.25, 0};
constexpr double kMost = 40;

void expect(const Reference& reference, bool takes_effort, Way way, double value) {
  const Command command = commandOf(reference, kMeasured, takes_effort, kMost);
  EXPECT_EQ(command.way, way);
  EXPECT_DOUBLE_EQ(command.value, value);
}

TEST(GazeboDrive, the_leading_mode_is_sent) {
  expect({0.7, 0.1, 0, 0, 0, link::kPosition | link::kVelocity}, true, Way::kPosition, 0.7);
  expect({0.7, 0.1, 0, 0, 0, link::kVelocity}, true, Way::kVelocity, 0.1);
  expect({0.7, 0.1, 12, 0, 0, link::kEffort}, false, Way::kEffort, 12);
  expect({0.7, 0.1, 12, 0, 0, 0}, true, Way::kNone, 0);
}

TEST(GazeboDrive, a_stiffness_and_a_damping_are_an_effort_within_its_limit) {
  const std::uint8_t all = link::kPosition | link::kEffort | link::kImpedance;
  expect({0.7, 0, 3, 50, 4, all}, true, Way::kEffort, 3 + 50 * (0.7 - 0.5) - 4 * 0.25);
  expect({0.7, 0.5, 3, 50, 4, static_cast<std::uint8_t>(all | link::kVelocity)}, true, Way::kEffort,
         3 + 50 * (0.7 - 0.5) + 4 * 0.25);
  expect({2.5, 0, 0, 1000, 0, all}, true, Way::kEffort, kMost);
  expect({-2.5, 0, 0, 1000, 0, all}, true, Way::kEffort, -kMost);
}

TEST(GazeboDrive, without_a_controller_of_efforts_a_stiffness_has_no_effect) {
  expect({0.7, 0, 0, 50, 4, link::kPosition | link::kImpedance}, false, Way::kPosition, 0.7);
}

}  // namespace
}  // namespace robotui::rt::hal
