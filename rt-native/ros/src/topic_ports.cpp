// Ports that are topics.
#include <ros/ros.h>

#include "message_shape.h"
#include "ports.h"
#include "raw_message.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::uint32_t kQueue = 20;

class PublishPort final : public Port {
 public:
  PublishPort(const ros::Announcement& port, const PortPlace& place)
      : reader_(place.channels, place.outName(), port.large) {
    ::ros::AdvertiseOptions options(place.topic(port.name), kQueue, port.md5, port.type, port.definition);
    options.latch = port.latched;
    publisher_ = node_.advertise(options);
  }
  void turn() override {
    while (reader_.next()) {
      message_.bytes.assign(reader_.bytes().begin(), reader_.bytes().end());
      publisher_.publish(message_);
    }
  }

 private:
  ros::PacketReader reader_;
  RawMessage message_;
  ::ros::NodeHandle node_;
  ::ros::Publisher publisher_;
};

class SubscribePort final : public Port {
 public:
  SubscribePort(const ros::Announcement& port, const PortPlace& place)
      : shape_(MessageShape::parse(port.definition)), generation_(port.generation), topic_(place.topic(port.name)),
        log_(place.log), writer_(place.channels, place.inName(), port.large) {
    ::ros::SubscribeOptions options(topic_, kQueue, port.md5, port.type);
    options.helper = boost::make_shared<::ros::SubscriptionCallbackHelperT<const RawMessage::ConstPtr&>>(
        [this](const RawMessage::ConstPtr& message) { take(*message); });
    options.callback_queue = &place.queue;
    options.transport_hints = ::ros::TransportHints().tcpNoDelay();
    subscriber_ = node_.subscribe(options);
  }

 private:
  void take(const RawMessage& message) {
    const bool fits = message.bytes.size() <= writer_.room() && shape_.fits(message.bytes);
    if (fits) {
      writer_.write(message.bytes, 0, generation_);
    } else if (!complained_) {
      complained_ = true;
      log_("warn", "a message of " + topic_ + " with " + std::to_string(message.bytes.size()) +
                       " bytes is not handed to its plugin, which takes whole ones of up to " +
                       std::to_string(writer_.room()) + "; of others that come nothing more is said.");
    }
  }

  MessageShape shape_;
  std::uint64_t generation_;
  std::string topic_;
  LogFunction log_;
  bool complained_ = false;
  ros::PacketWriter writer_;
  ::ros::NodeHandle node_;
  ::ros::Subscriber subscriber_;  // last: its callbacks use the others
};

}  // namespace

std::unique_ptr<Port> makePublishPort(const ros::Announcement& port, const PortPlace& place) {
  return std::make_unique<PublishPort>(port, place);
}

std::unique_ptr<Port> makeSubscribePort(const ros::Announcement& port, const PortPlace& place) {
  return std::make_unique<SubscribePort>(port, place);
}

std::unique_ptr<Port> makePort(const ros::Announcement& port, const PortPlace& place) {
  switch (port.kind) {
    case ros::PortKind::kPublish: return makePublishPort(port, place);
    case ros::PortKind::kSubscribe: return makeSubscribePort(port, place);
    case ros::PortKind::kServe: return makeServePort(port, place);
    case ros::PortKind::kTune: return makeTunePort(port, place);
  }
  throw std::runtime_error("it is of a kind that is not known");
}

}  // namespace robotui::rt::ros_bridge
