// Services whose callback runs in the control loop of a plugin.
#include <ros/ros.h>

#include "pending_calls.h"
#include "message_shape.h"
#include "ports.h"
#include "raw_message.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::chrono::milliseconds kPatience{2000};

// What ROS tells the caller of a service that failed: a text with its length.
RawMessage failure(const std::string& text) {
  RawMessage message;
  const auto length = static_cast<std::uint32_t>(text.size());
  const auto* at = reinterpret_cast<const std::uint8_t*>(&length);
  message.bytes.assign(at, at + sizeof(length));
  message.bytes.insert(message.bytes.end(), text.begin(), text.end());
  return message;
}

using Handle = std::function<CallAnswer(std::span<const std::uint8_t>)>;

class RawHelper final : public ::ros::ServiceCallbackHelper {
 public:
  explicit RawHelper(Handle handle) : handle_(std::move(handle)) {}
  bool call(::ros::ServiceCallbackHelperCallParams& params) override {
    const auto& request = params.request;
    const auto skipped = static_cast<std::size_t>(request.message_start - request.buf.get());
    const CallAnswer answer = handle_({request.message_start, request.num_bytes - skipped});
    params.response = ::ros::serialization::serializeServiceResponse(
        answer.succeeded,
        answer.succeeded ? RawMessage{answer.bytes} : failure({answer.bytes.begin(), answer.bytes.end()}));
    return answer.succeeded;
  }

 private:
  Handle handle_;
};

CallAnswer refusal(const std::string& text) { return {false, {text.begin(), text.end()}}; }

class ServePort final : public Port {
 public:
  ServePort(const ros::Announcement& port, const PortPlace& place)
      : shape_(MessageShape::parse(port.definition)), generation_(port.generation), plugin_(place.plugin),
        reader_(place.channels, place.outName(), port.large), writer_(place.channels, place.inName(), port.large) {
    ::ros::AdvertiseServiceOptions options;
    options.service = place.topic(port.name);
    options.md5sum = port.md5;
    options.datatype = port.type;
    options.req_datatype = port.type + "Request";
    options.res_datatype = port.type + "Response";
    options.helper =
        boost::make_shared<RawHelper>([this](std::span<const std::uint8_t> request) { return call(request); });
    options.callback_queue = &place.queue;
    server_ = node_.advertiseService(options);
    if (!server_) throw std::runtime_error("there is such a service already");
  }

  void turn() override {
    while (reader_.next()) {
      const bool succeeded = (reader_.flags() & ros::kSucceeded) != 0;
      answers_.settle(reader_.number(), succeeded ? CallAnswer{true, {reader_.bytes().begin(), reader_.bytes().end()}}
                                                  : refusal("the plugin " + plugin_ + " refused it"));
    }
  }

 private:
  CallAnswer call(std::span<const std::uint8_t> request) {
    if (request.size() > writer_.room() || !shape_.fits(request))
      return refusal("the request is too long for a plugin");
    const std::uint32_t number = answers_.expect();
    {
      const std::scoped_lock lock(writing_);
      writer_.write(request, number, generation_);
    }
    const auto answer = answers_.await(number, kPatience);
    return answer ? *answer : refusal("the plugin " + plugin_ + " did not answer: does it run?");
  }

  MessageShape shape_;
  std::uint64_t generation_;
  std::string plugin_;
  PendingCalls answers_;
  std::mutex writing_;
  ros::PacketReader reader_;
  ros::PacketWriter writer_;
  ::ros::NodeHandle node_;
  ::ros::ServiceServer server_;  // last: its callbacks use the others
};

}  // namespace

std::unique_ptr<Port> makeServePort(const ros::Announcement& port, const PortPlace& place) {
  return std::make_unique<ServePort>(port, place);
}

}  // namespace robotui::rt::ros_bridge
