// The example plugin with a ROS process that keeps it busy: its loop asks nothing of the heap.
#include "RosExample/ros_example.h"

#include <gtest/gtest.h>

#include "far_side.h"

namespace robotui::rt::plugins {
namespace {

using ros::bytesOf;
using ros::eventually;
using testing::FakeRobot;
using testing::FakeSetup;
using testing::PluginBench;

enum Port : std::size_t { kPosition, kOffset, kHold, kTuning };

class RosExampleTest : public ::testing::Test {
 protected:
  RosExampleTest() {
    if (!bench_.init()) throw std::runtime_error(setup_.failure());
    bench_.start();
  }
  ~RosExampleTest() override {
    bench_.stop();
    bench_.close();
  }
  bool cycleUntil(const std::function<bool()>& condition) {
    return eventually([&] {
      bench_.cycles(1);
      return condition();
    });
  }

  FakeRobot robot_{2};
  FakeSetup setup_{robot_, "{joint: j2}"};
  RosExample plugin_;
  PluginBench bench_{plugin_, setup_};
  ros::FarSide far_{setup_};
};

TEST_F(RosExampleTest, FollowsATopic) {
  ros::PacketWriter offset = far_.to(kOffset);
  std_msgs::Float64 message;
  message.data = 0.4;
  offset.write(bytesOf(message), 0, far_.announced(kOffset).generation);
  EXPECT_TRUE(cycleUntil([&] { return robot_.joint(1).getJointPosition() > 0.25; }));
  EXPECT_EQ(robot_.joint(0).getJointPosition(), 0) << "the other one is not its own";
}

TEST_F(RosExampleTest, PublishesWhereTheJointIs) {
  ros::PacketReader position = far_.from(kPosition);
  ASSERT_TRUE(cycleUntil([&] { return position.next(); }));
  EXPECT_NEAR(ros::messageOf<std_msgs::Float64>(position.bytes()).data, 0, 0.2);
}

TEST_F(RosExampleTest, HoldsWhenItIsCalled) {
  ros::PacketWriter call = far_.to(kHold);
  ros::PacketReader answer = far_.from(kHold);
  std_srvs::SetBoolRequest request;
  request.data = 1;
  call.write(bytesOf(request), 9, far_.announced(kHold).generation);
  ASSERT_TRUE(cycleUntil([&] { return answer.next(); }));
  EXPECT_EQ(ros::messageOf<std_srvs::SetBoolResponse>(answer.bytes()).message, "holds");
  EXPECT_EQ(plugin_.status(), "holding");
}

TEST_F(RosExampleTest, AsksNothingOfTheHeapWhileAllOfItIsUsed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer allocates itself";
#endif
  ros::PacketWriter offset = far_.to(kOffset);
  ros::PacketWriter call = far_.to(kHold);
  ros::PacketReader answer = far_.from(kHold);
  ros::PacketWriter tuning = far_.to(kTuning);
  ros::PacketReader tuned = far_.from(kTuning);
  const auto generation = far_.announced(kOffset).generation;
  std_msgs::Float64 message;
  std_srvs::SetBoolRequest request;
  int answered = 0;
  int applied = 0;
  for (int round = 0; round < 100; ++round) {
    message.data = 0.001 * round;
    offset.write(bytesOf(message), 0, generation);
    request.data = static_cast<std::uint8_t>(round % 2);
    call.write(bytesOf(request), static_cast<std::uint32_t>(round), generation);
    const std::array<double, 2> values{0.1 + 0.001 * round, 0.5};
    tuning.write(std::span(reinterpret_cast<const std::uint8_t*>(values.data()), sizeof(values)),
                 static_cast<std::uint32_t>(round), generation);
    ASSERT_TRUE(cycleUntil([&] { return answer.next(); }));
    ++answered;
    while (tuned.next()) ++applied;
  }
  EXPECT_EQ(answered, 100);
  EXPECT_GE(applied, 100);
  EXPECT_EQ(bench_.allocations(), 0u);
}

}  // namespace
}  // namespace robotui::rt::plugins
