#include "robotui/rt/link/trajectory_orders.h"

#include <gtest/gtest.h>

namespace robotui::rt::link {
namespace {

TEST(TrajectoryOrders, GoIntoOneWhereTheyFit) {
  TrajectoryOrders orders;
  const std::vector<std::string> names{"a", "b"};
  orders.joints(names);
  orders.point(1.5);
  const std::vector<double> positions{0.25, -1e-7};
  orders.values("positions", positions);
  orders.say("path", 0.1, "b");
  orders.say("speed", 0.5);
  const std::string tag = "@" + std::to_string(orders.tag()) + " ";
  EXPECT_EQ(orders.stop(), tag + "stop");
  EXPECT_EQ(orders.take(), std::vector<std::string>{
                               tag + "begin;joints a b;point 1.5;positions 0.25 -1e-07;path 0.1 b;speed 0.5;run"});
}

TEST(TrajectoryOrders, AreNeverLongerThanAPluginTakes) {
  TrajectoryOrders orders;
  const std::vector<std::string> names(100, "a_joint_with_a_long_name");
  orders.joints(names);
  for (int i = 0; i < 20; ++i) {
    orders.point(i);
    orders.values("positions", std::vector<double>(100, -0.123456789012345));
  }
  std::size_t values = 0;
  for (const std::string& order : orders.take()) {
    EXPECT_LT(order.size(), 496U);
    EXPECT_TRUE(order.starts_with('@'));
    for (std::size_t at = 0; (at = order.find(" -0.123456789012", at)) != std::string::npos; ++at) ++values;
  }
  EXPECT_EQ(values, 2000U);
}

TEST(TrajectoryOrders, OfTwoClientsHaveOtherTags) {
  const TrajectoryOrders one;
  const TrajectoryOrders other;
  EXPECT_NE(one.tag(), 0U);
  EXPECT_NE(one.tag(), other.tag());
}

}  // namespace
}  // namespace robotui::rt::link
