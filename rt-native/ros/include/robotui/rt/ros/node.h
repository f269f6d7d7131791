// Topics, services and tunable parameters of ROS for a plugin, without a blocking call in its control loop.
//
// Made in init_control_plugin, ended in close(): declare all, then open(). In the loop: publish() serialises into
// memory that the ROS process reads; spin() runs the callbacks of what has come. Messages that are used again keep
// their memory: size their arrays in init.
#pragma once

#include <chrono>
#include <list>
#include <thread>

#include <ros/message_traits.h>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/plugin/control_plugin.h"
#include "robotui/rt/ros/inbox.h"
#include "robotui/rt/ros/tunables.h"

namespace robotui::rt::ros {

enum class Published : std::uint8_t { kOk, kTooLarge };

template <typename Message>
class Publisher {
 public:
  Publisher() = default;
  explicit Publisher(PacketWriter writer) : writer_(std::move(writer)) {}

  // In the control loop. What the ROS process does not fetch in time is overwritten.
  Published publish(const Message& message) noexcept {
    return detail::encode(message, writer_, 0, 0) ? Published::kOk : Published::kTooLarge;
  }

 private:
  PacketWriter writer_;
};

// `large` messages have up to 4064 bytes and the last two of them are kept, others up to 1000 and the last eight.
struct PortOptions {
  bool large = false;
  bool latched = false;   // of a publisher: who comes late gets the last one
  std::size_t queue = 8;  // of a subscriber: messages that wait for the loop
};

class Node {
 public:
  explicit Node(Setup& setup)
      : plugin_(setup.name()), channels_(setup.channels()), generation_(static_cast<std::uint64_t>(link::now())) {}
  ~Node() { close(); }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  // Names are those of ROS: `/absolute`, or beneath /xbotcore/PLUGIN/. All of these throw std::runtime_error with a
  // sentence.
  template <typename Message>
  Publisher<Message> advertise(const std::string& topic, PortOptions options = {}) {
    Announcement& port = announceMessage<Message>(PortKind::kPublish, topic, options);
    return Publisher<Message>(writer(port));
  }

  // Copies of `prototype` wait for what comes: with arrays and strings of the size to be expected.
  template <typename Message>
  void subscribe(const std::string& topic, std::function<void(const Message&)> callback, PortOptions options = {},
                 const Message& prototype = {}) {
    Announcement& port = announceMessage<Message>(PortKind::kSubscribe, topic, options);
    inboxes_.push_back(std::make_unique<Subscription<Message>>(reader(port), generation_, options.queue, prototype,
                                                               std::move(callback)));
  }

  template <typename Service>
  void serve(const std::string& name, typename Server<Service>::Callback callback, PortOptions options = {},
             const Service& prototype = {}) {
    Announcement& port = announce(PortKind::kServe, name, options);
    port.type = ::ros::service_traits::DataType<Service>::value();
    port.md5 = ::ros::service_traits::MD5Sum<Service>::value();
    port.definition = ::ros::message_traits::Definition<typename Service::Request>::value();
    inboxes_.push_back(
        std::make_unique<Server<Service>>(reader(port), writer(port), generation_, prototype, std::move(callback)));
  }

  Tunable<double> tune(const std::string& name, double initial, double least, double most,
                       const std::string& description) {
    return Tunable<double>(tunables_.add({name, description, TunableType::kDouble, initial, least, most}));
  }
  Tunable<int> tune(const std::string& name, int initial, int least, int most, const std::string& description) {
    return Tunable<int>(
        tunables_.add({name, description, TunableType::kInt, double(initial), double(least), double(most)}));
  }
  Tunable<bool> tune(const std::string& name, bool initial, const std::string& description) {
    return Tunable<bool>(tunables_.add({name, description, TunableType::kBool, double(initial), 0, 1}));
  }

  // At the end of init: tells all to the ROS process.
  void open() {
    offerTunables();
    for (std::size_t i = 0; i < ports_.size(); ++i) say(i);
    thread_ = std::thread([this] { receive(); });
  }

  // In the control loop.
  void spin() {
    if (!tunables_.entries().empty()) tunables_.apply(tuned_, generation_, tuning_);
    for (auto& inbox : inboxes_) inbox->execute();
  }

  void close() {
    going_.store(false, std::memory_order_relaxed);
    if (thread_.joinable()) thread_.join();
    announced_.clear();
  }

 private:
  static constexpr std::chrono::milliseconds kPoll{1};

  template <typename Message>
  Announcement& announceMessage(PortKind kind, const std::string& name, const PortOptions& options) {
    Announcement& port = announce(kind, name, options);
    port.type = ::ros::message_traits::DataType<Message>::value();
    port.md5 = ::ros::message_traits::MD5Sum<Message>::value();
    port.definition = ::ros::message_traits::Definition<Message>::value();
    return port;
  }

  Announcement& announce(PortKind kind, const std::string& name, const PortOptions& options) {
    if (ports_.size() == kMostPorts)
      throw std::runtime_error("A plugin can have " + std::to_string(kMostPorts) + " topics and services.");
    Announcement port;
    port.kind = kind;
    port.large = options.large;
    port.latched = options.latched;
    port.generation = generation_;
    port.name = name;
    return ports_.emplace_back(std::move(port));
  }

  std::size_t last() const noexcept { return ports_.size() - 1; }
  PacketReader reader(const Announcement& port) { return {channels_, channelName(plugin_, last(), true), port.large}; }
  PacketWriter writer(const Announcement& port) { return {channels_, channelName(plugin_, last(), false), port.large}; }

  void offerTunables() {
    if (tunables_.entries().empty()) return;
    Announcement& port = announce(PortKind::kTune, "", {});
    port.tunables = tunables_.entries();
    tuned_ = reader(port);
    tuning_ = writer(port);
    tunables_.tell(tuning_, 0);
  }

  void say(std::size_t i) {
    const std::vector<std::uint8_t> bytes = write(ports_[i]);
    if (bytes.size() > AnnouncedPacket::kRoom)
      throw std::runtime_error("The definition of " + ports_[i].type + " is too long for a topic of a plugin.");
    const auto packet = std::make_unique<AnnouncedPacket>();
    packet->size = static_cast<std::uint32_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), packet->data.begin());
    announced_.emplace_back(channels_, announcementName(plugin_, i), AnnouncedPacket::kDepth);
    announced_.back().write(*packet);
  }

  void receive() {
    while (going_.load(std::memory_order_relaxed)) {
      for (auto& inbox : inboxes_) inbox->receive();
      std::this_thread::sleep_for(kPoll);
    }
  }

  std::string plugin_;
  ChannelDirectory& channels_;
  std::uint64_t generation_;
  std::vector<Announcement> ports_;
  std::list<ChannelWriter<AnnouncedPacket>> announced_;
  std::vector<std::unique_ptr<Inbox>> inboxes_;
  Tunables tunables_;
  PacketReader tuned_;
  PacketWriter tuning_;
  std::atomic<bool> going_{true};
  std::thread thread_;
};

}  // namespace robotui::rt::ros
