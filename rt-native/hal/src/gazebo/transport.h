// The Gazebo transport without its headers, which take long to compile: topics as bytes and the names of their types.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace robotui::rt::hal::gazebo {

// A number that goes out on a topic. For one ordinary thread.
class NumberOutput {
 public:
  virtual ~NumberOutput() = default;
  virtual void publish(double value) = 0;
  virtual bool hasListeners() const = 0;
};

// Who sends on a topic.
struct TopicSource {
  std::string type;
  std::string address;
};

class Transport {
 public:
  // On a thread of the transport, perhaps on several at once, and perhaps still while the transport is being closed.
  using Heard = std::function<void(std::string_view type, std::span<const std::byte> message)>;

  // `address` is that of the network interface, for the whole process, where its environment does not say another one;
  // an empty partition is that of the environment. Throws std::runtime_error where the partition cannot be one.
  Transport(const std::string& address, const std::string& partition);
  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  void subscribe(const std::string& topic, Heard heard);
  std::unique_ptr<NumberOutput> advertise(const std::string& topic);

  std::vector<std::string> topics() const;  // of others
  std::vector<TopicSource> sourcesOf(const std::string& topic) const;
  std::string partition() const;
  static std::string address();  // of this process's network interface

  // Asks the world to be paused. False where it did not answer in time, or refused.
  bool pauseWorld(const std::string& service, unsigned timeout_ms);

 private:
  struct Node;
  std::unique_ptr<Node> node_;
};

}  // namespace robotui::rt::hal::gazebo
