// A message as its bytes, of whatever type: what passes between topics and plugins, and commands of any version.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <boost/shared_ptr.hpp>
#include <ros/message_traits.h>
#include <ros/serialization.h>

namespace robotui::rt::ros_bridge {

struct RawMessage {
  std::vector<std::uint8_t> bytes;
  using ConstPtr = boost::shared_ptr<RawMessage const>;
};

}  // namespace robotui::rt::ros_bridge

namespace ros::message_traits {

template <>
struct IsMessage<robotui::rt::ros_bridge::RawMessage> : TrueType {};
template <>
struct MD5Sum<robotui::rt::ros_bridge::RawMessage> {
  static const char* value() { return "*"; }
  static const char* value(const robotui::rt::ros_bridge::RawMessage&) { return value(); }
};
template <>
struct DataType<robotui::rt::ros_bridge::RawMessage> {
  static const char* value() { return "*"; }
  static const char* value(const robotui::rt::ros_bridge::RawMessage&) { return value(); }
};
template <>
struct Definition<robotui::rt::ros_bridge::RawMessage> {
  static const char* value() { return ""; }
  static const char* value(const robotui::rt::ros_bridge::RawMessage&) { return value(); }
};

}  // namespace ros::message_traits

namespace ros::serialization {

template <>
struct Serializer<robotui::rt::ros_bridge::RawMessage> {
  template <typename Stream>
  static void write(Stream& stream, const robotui::rt::ros_bridge::RawMessage& message) {
    std::copy(message.bytes.begin(), message.bytes.end(),
              stream.advance(static_cast<std::uint32_t>(message.bytes.size())));
  }
  template <typename Stream>
  static void read(Stream& stream, robotui::rt::ros_bridge::RawMessage& message) {
    message.bytes.assign(stream.getData(), stream.getData() + stream.getLength());
  }
  static std::uint32_t serializedLength(const robotui::rt::ros_bridge::RawMessage& message) {
    return static_cast<std::uint32_t>(message.bytes.size());
  }
};

}  // namespace ros::serialization
