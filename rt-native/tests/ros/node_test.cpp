#include "robotui/rt/ros/node.h"

#include <gtest/gtest.h>

#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>

#include "far_side.h"

namespace robotui::rt::ros {
namespace {

using testing::FakeRobot;
using testing::FakeSetup;

class NodeTest : public ::testing::Test {
 protected:
  FakeRobot robot_{1};
  FakeSetup setup_{robot_, ""};
  FarSide far_{setup_};
  Node node_{setup_};

  bool spinUntil(const std::function<bool()>& condition) {
    return eventually([&] {
      node_.spin();
      return condition();
    });
  }
};

TEST_F(NodeTest, SaysWhatItOffers) {
  node_.advertise<std_msgs::Float64>("value", {.large = true, .latched = true});
  node_.open();
  const Announcement port = far_.announced(0);
  EXPECT_EQ(port.kind, PortKind::kPublish);
  EXPECT_EQ(port.name, "value");
  EXPECT_EQ(port.type, "std_msgs/Float64");
  EXPECT_EQ(port.md5, "fdb28210bfa9d7c91146260178d9a584");
  EXPECT_TRUE(port.latched);
  EXPECT_TRUE(port.large);
}

TEST_F(NodeTest, PublishesInOrder) {
  auto publisher = node_.advertise<std_msgs::Float64>("value");
  node_.open();
  PacketReader reader = far_.from(0);
  std_msgs::Float64 message;
  for (int i = 0; i < 5; ++i) {
    message.data = i;
    EXPECT_EQ(publisher.publish(message), Published::kOk);
  }
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(messageOf<std_msgs::Float64>(reader.bytes()).data, i);
  }
  EXPECT_FALSE(reader.next());
}

TEST_F(NodeTest, RefusesWhatDoesNotFit) {
  auto small = node_.advertise<std_msgs::String>("small");
  auto large = node_.advertise<std_msgs::String>("large", {.large = true});
  std_msgs::String message;
  message.data.assign(2000, 'x');
  EXPECT_EQ(small.publish(message), Published::kTooLarge);
  EXPECT_EQ(large.publish(message), Published::kOk);
}

TEST_F(NodeTest, RunsCallbacksInTheLoopAndNowhereElse) {
  std::vector<std::string> got;
  const auto loop = std::this_thread::get_id();
  node_.subscribe<std_msgs::String>("words", [&](const std_msgs::String& message) {
    EXPECT_EQ(std::this_thread::get_id(), loop);
    got.push_back(message.data);
  });
  node_.open();
  PacketWriter writer = far_.to(0);
  std_msgs::String message;
  for (int i = 0; i < 40; ++i) {
    message.data = "a text that is longer than what a string keeps in itself " + std::to_string(i);
    writer.write(bytesOf(message), 0, far_.announced(0).generation);
    ASSERT_TRUE(spinUntil([&] { return got.size() == static_cast<std::size_t>(i + 1); }));
    EXPECT_EQ(got.back(), message.data);
  }
}

TEST_F(NodeTest, PassesOverWhatIsOfAnotherLifeOrNoMessage) {
  std::vector<double> got;
  node_.subscribe<std_msgs::Float64>("value", [&](const std_msgs::Float64& message) { got.push_back(message.data); });
  node_.open();
  PacketWriter writer = far_.to(0);
  const auto generation = far_.announced(0).generation;
  std_msgs::Float64 message;
  message.data = 1;
  writer.write(bytesOf(message), 0, generation + 1);
  writer.write(std::vector<std::uint8_t>(3), 0, generation);
  message.data = 2;
  writer.write(bytesOf(message), 0, generation);
  ASSERT_TRUE(spinUntil([&] { return !got.empty(); }));
  EXPECT_EQ(got, std::vector<double>{2});
}

TEST_F(NodeTest, AnswersCalls) {
  node_.serve<std_srvs::SetBool>("switch", [](const auto& request, auto& response) {
    response.success = request.data;
    response.message = "done";
    return request.data != 0;
  });
  node_.open();
  const Announcement port = far_.announced(0);
  EXPECT_EQ(port.kind, PortKind::kServe);
  EXPECT_EQ(port.md5, "09fb03525b03e7ea1fd3992bafd87e16");
  PacketWriter writer = far_.to(0);
  PacketReader reader = far_.from(0);
  std_srvs::SetBoolRequest request;
  request.data = 1;
  writer.write(bytesOf(request), 41, port.generation);
  ASSERT_TRUE(spinUntil([&] { return reader.next(); }));
  EXPECT_EQ(reader.number(), 41u);
  EXPECT_EQ(reader.flags(), kSucceeded);
  EXPECT_EQ(messageOf<std_srvs::SetBoolResponse>(reader.bytes()).message, "done");
  request.data = 0;
  writer.write(bytesOf(request), 42, port.generation);
  ASSERT_TRUE(spinUntil([&] { return reader.next(); }));
  EXPECT_EQ(reader.flags(), 0u);
}

TEST_F(NodeTest, TunesWithinTheLimitsAndTellsWhatHolds) {
  const Tunable<double> gain = node_.tune("gain", 0.5, 0.0, 2.0, "");
  const Tunable<int> count = node_.tune("count", 3, 1, 9, "");
  const Tunable<bool> on = node_.tune("on", true, "");
  node_.open();
  const Announcement port = far_.announced(0);
  ASSERT_EQ(port.tunables.size(), 3u);
  PacketReader reader = far_.from(0);
  ASSERT_TRUE(reader.next()) << "what holds from the beginning";
  const std::array<double, 3> wanted{7.0, 4.0, 0.0};
  PacketWriter writer = far_.to(0);
  writer.write(std::span(reinterpret_cast<const std::uint8_t*>(wanted.data()), sizeof(wanted)), 5, port.generation);
  EXPECT_EQ(gain.get(), 0.5) << "nothing changes within a loop";
  node_.spin();
  EXPECT_EQ(gain.get(), 2.0);
  EXPECT_EQ(count.get(), 4);
  EXPECT_FALSE(on.get());
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.number(), 5u);
}

TEST_F(NodeTest, HasRoomForSoManyPortsOnly) {
  EXPECT_THROW(
      {
        for (int i = 0; i < 40; ++i) node_.subscribe<std_msgs::Float64>("t" + std::to_string(i), [](const auto&) {});
      },
      std::runtime_error);
}

TEST(SlotQueue, HandsOverWithoutALossOrALock) {
  SlotQueue<int> queue(4, 0);
  constexpr int kMany = 20000;
  std::thread writer([&] {
    for (int i = 0; i < kMany;) {
      if (int* slot = queue.back(); slot != nullptr) {
        *slot = i++;
        queue.push();
      }
    }
  });
  for (int i = 0; i < kMany;) {
    if (const int* slot = queue.front(); slot != nullptr) {
      EXPECT_EQ(*slot, i++);
      queue.pop();
    }
  }
  writer.join();
  EXPECT_EQ(queue.front(), nullptr);
}

}  // namespace
}  // namespace robotui::rt::ros
