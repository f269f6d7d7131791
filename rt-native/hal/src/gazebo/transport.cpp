#include "transport.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/world_control.pb.h>
#include <ignition/transport/Node.hh>

namespace robotui::rt::hal::gazebo {

namespace {

namespace it = ignition::transport;

constexpr const char* kInterface = "IGN_IP";

it::NodeOptions optionsFor(const std::string& address, const std::string& partition) {
  ::setenv(kInterface, address.c_str(), 0);  // read when the first node of the process is made
  it::NodeOptions options;
  if (!partition.empty() && !options.SetPartition(partition)) {
    throw std::runtime_error("'" + partition +
                             "' cannot be a partition of the Gazebo transport: write a word without spaces.");
  }
  return options;
}

class Number : public NumberOutput {
 public:
  explicit Number(it::Node::Publisher publisher) : publisher_(std::move(publisher)) {}
  void publish(double value) override {
    message_.set_data(value);
    publisher_.Publish(message_);
  }
  bool hasListeners() const override { return publisher_.HasConnections(); }

 private:
  it::Node::Publisher publisher_;
  ignition::msgs::Double message_;
};

[[noreturn]] void refuse(const std::string& topic) {
  throw std::runtime_error("The Gazebo transport refuses the topic '" + topic +
                           "': write another one into HALInterface.params.topics.");
}

}  // namespace

struct Transport::Node {
  explicit Node(const it::NodeOptions& options) : node(options) {}
  it::Node node;
};

Transport::Transport(const std::string& address, const std::string& partition)
    : node_(std::make_unique<Node>(optionsFor(address, partition))) {}

Transport::~Transport() = default;

void Transport::subscribe(const std::string& topic, Heard heard) {
  const auto call = [heard = std::move(heard)](const char* data, std::size_t size, const it::MessageInfo& info) {
    heard(info.Type(), std::as_bytes(std::span(data, size)));
  };
  if (!node_->node.SubscribeRaw(topic, call)) refuse(topic);
}

std::unique_ptr<NumberOutput> Transport::advertise(const std::string& topic) {
  it::Node::Publisher publisher = node_->node.Advertise<ignition::msgs::Double>(topic);
  if (!publisher) refuse(topic);
  return std::make_unique<Number>(std::move(publisher));
}

std::vector<std::string> Transport::topics() const {
  std::vector<std::string> topics;
  node_->node.TopicList(topics);
  const std::vector<std::string> own = node_->node.AdvertisedTopics();
  std::erase_if(topics,
                [&](const std::string& topic) { return std::find(own.begin(), own.end(), topic) != own.end(); });
  return topics;
}

std::vector<TopicSource> Transport::sourcesOf(const std::string& topic) const {
  std::vector<it::MessagePublisher> publishers;
  node_->node.TopicInfo(topic, publishers);
  std::vector<TopicSource> sources;
  for (const it::MessagePublisher& each : publishers) sources.push_back({each.MsgTypeName(), each.Addr()});
  return sources;
}

std::string Transport::address() {
  const char* address = std::getenv(kInterface);
  return address == nullptr ? "" : address;
}

std::string Transport::partition() const { return node_->node.Options().Partition(); }

bool Transport::pauseWorld(const std::string& service, unsigned timeout_ms) {
  ignition::msgs::WorldControl request;
  request.set_pause(true);
  ignition::msgs::Boolean reply;
  bool done = false;
  return node_->node.Request(service, request, timeout_ms, reply, done) && done && reply.data();
}

}  // namespace robotui::rt::hal::gazebo
