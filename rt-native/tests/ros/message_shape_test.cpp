#include "message_shape.h"

#include <gtest/gtest.h>

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>
#include <xbot_msgs/JointCommand.h>

namespace robotui::rt::ros_bridge {
namespace {

template <typename Message>
std::vector<std::uint8_t> bytesOf(const Message& message) {
  std::vector<std::uint8_t> bytes(::ros::serialization::serializationLength(message));
  ::ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ::ros::serialization::serialize(stream, message);
  return bytes;
}

template <typename Message>
MessageShape shapeOf() {
  return MessageShape::parse(::ros::message_traits::Definition<Message>::value());
}

xbot_msgs::JointCommand command() {
  xbot_msgs::JointCommand message;
  message.header.frame_id = "somewhere";
  message.name = {"a", "b"};
  message.position = {0.5F, -1.0F};
  message.damping = {1.25, 2.5};
  message.ctrl_mode = {1, 17};
  message.aux_name = "nothing";
  return message;
}

TEST(MessageShape, ReadsTheArraysOfAMessageByTheirNames) {
  const Columns columns = shapeOf<xbot_msgs::JointCommand>().read(bytesOf(command()));
  EXPECT_EQ(columns.texts.at("name"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(columns.numbers.at("position"), (std::vector<double>{0.5, -1.0}));
  EXPECT_EQ(columns.numbers.at("damping"), (std::vector<double>{1.25, 2.5}));
  EXPECT_EQ(columns.numbers.at("ctrl_mode"), (std::vector<double>{1, 17}));
}

TEST(MessageShape, ReadsAVersionWithOtherWidths) {
  const MessageShape shape =
      MessageShape::parse("string[] name\nfloat64[] position\nint8[] ctrl_mode # other than ours\n");
  const std::vector<std::uint8_t> bytes{1, 0, 0, 0, 1, 0, 0,    0,    'a', 1, 0, 0, 0,
                                        0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 1,   0, 0, 0, 0xff};
  const Columns columns = shape.read(bytes);
  EXPECT_EQ(columns.numbers.at("position").front(), 1.0);
  EXPECT_EQ(columns.numbers.at("ctrl_mode").front(), -1.0);
}

TEST(MessageShape, TakesNestedMessagesAndFixedArrays) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(3);
  message.transforms[1].child_frame_id = "link";
  const auto bytes = bytesOf(message);
  EXPECT_TRUE(shapeOf<tf2_msgs::TFMessage>().fits(bytes));
  EXPECT_TRUE(MessageShape::parse("uint8[4] a\nfloat32 b\n").fits(std::vector<std::uint8_t>(8)));
}

TEST(MessageShape, RefusesEveryCutMessage) {
  const MessageShape shape = shapeOf<xbot_msgs::JointCommand>();
  const auto bytes = bytesOf(command());
  ASSERT_TRUE(shape.fits(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(shape.fits(std::span(bytes).first(size))) << size;
}

TEST(MessageShape, RefusesALengthThatIsBeyondTheMessage) {
  const MessageShape shape = MessageShape::parse("float64[] values\n");
  const std::vector<std::uint8_t> bytes{0xff, 0xff, 0xff, 0xff, 1, 2, 3, 4};
  EXPECT_FALSE(shape.fits(bytes));
  EXPECT_THROW(shape.read(bytes), ShapeError);
}

TEST(MessageShape, RefusesBytesBehindTheMessage) {
  auto bytes = bytesOf(command());
  bytes.push_back(0);
  EXPECT_FALSE(shapeOf<xbot_msgs::JointCommand>().fits(bytes));
}

TEST(MessageShape, RefusesDefinitionsThatAreNone) {
  EXPECT_THROW(MessageShape::parse("float64\n"), ShapeError);
  EXPECT_THROW(MessageShape::parse("other/Thing x\n"), ShapeError);
  EXPECT_THROW(MessageShape::parse("a/B x\n====\nMSG: a/B\na/B again\n"), ShapeError);
}

TEST(MessageShape, PassesConstantsAndCommentsOver) {
  const MessageShape shape = MessageShape::parse("# words\nuint8 ONE=1\nstring TEXT = some # thing\nuint8 value\n");
  EXPECT_TRUE(shape.fits(std::vector<std::uint8_t>{1}));
}

}  // namespace
}  // namespace robotui::rt::ros_bridge
