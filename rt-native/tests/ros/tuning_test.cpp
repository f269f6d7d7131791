#include "tuning.h"

#include <gtest/gtest.h>

#include <limits>

namespace robotui::rt::ros_bridge {
namespace {

const std::vector<ros::TunableEntry> kEntries{{"on", "", ros::TunableType::kBool, 1, 0, 1},
                                              {"count", "", ros::TunableType::kInt, 3, 1, 9},
                                              {"gain", "how much", ros::TunableType::kDouble, 0.5, 0, 2}};

TEST(Tuning, ValuesStandUnderTheirTypes) {
  const auto config = configOf(kEntries, {0, 7, 1.5});
  ASSERT_EQ(config.bools.size(), 1u);
  EXPECT_EQ(config.bools[0].value, 0);
  EXPECT_EQ(config.ints.at(0).value, 7);
  EXPECT_EQ(config.doubles.at(0).value, 1.5);
  EXPECT_EQ(config.groups.at(0).name, "Default");
}

TEST(Tuning, TheDescriptionHasLimitsAndDefaults) {
  const auto description = descriptionOf(kEntries);
  EXPECT_EQ(description.groups.at(0).parameters.at(2).description, "how much");
  EXPECT_EQ(description.groups.at(0).parameters.at(1).type, "int");
  EXPECT_EQ(description.max.ints.at(0).value, 9);
  EXPECT_EQ(description.dflt.doubles.at(0).value, 0.5);
}

TEST(Tuning, OnlyWhatIsNamedChangesAndStaysWithinItsLimits) {
  dynamic_reconfigure::Config wanted;
  wanted.ints.resize(1);
  wanted.ints[0].name = "count";
  wanted.ints[0].value = 99;
  wanted.doubles.resize(2);
  wanted.doubles[0].name = "unknown";
  wanted.doubles[1].name = "gain";
  wanted.doubles[1].value = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values{1, 3, 0.5};
  merge(wanted, kEntries, values);
  EXPECT_EQ(values, (std::vector<double>{1, 9, 0.5}));
}

}  // namespace
}  // namespace robotui::rt::ros_bridge
