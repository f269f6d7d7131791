// Takes what one sensor sends, on the threads of the transport, and keeps the newest for the thread of real time.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "messages.h"
#include "newest.h"
#include "../notices.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::gazebo {

template <class State>
class SensorInbox {
 public:
  using Decode = std::function<std::optional<State>(Bytes)>;

  // `type` is the message that is expected.
  SensorInbox(std::string name, std::string topic, std::string_view type, Decode decode,
              std::shared_ptr<Notices> notices)
      : name_(std::move(name)), topic_(std::move(topic)), type_(type), decode_(std::move(decode)),
        notices_(std::move(notices)) {}

  // By the transport.
  void hear(std::string_view type, Bytes message) {
    const auto state = isType(type, type_) ? decode_(message) : std::nullopt;
    if (!state) {
      notices_->tell("sensor " + name_,
                     "What comes on " + topic_ + " from the sensor '" + name_ + "', a " + std::string(type) +
                         ", is no sound " + type_ + ": its last value stays.",
                     link::now());
      return;
    }
    const std::lock_guard lock(mutex_);
    newest_.write(*state);
    heard_ns_.store(link::now(), std::memory_order_release);
  }

  // By one thread, which neither waits nor allocates here: untouched where nothing is new.
  void read(State& into) noexcept {
    State state{};
    if (newest_.read(state, last_) == link::Read::kNew) into = state;
  }

  std::int64_t heardNs() const noexcept { return heard_ns_.load(std::memory_order_acquire); }  // 0 is never
  const std::string& name() const noexcept { return name_; }
  const std::string& topic() const noexcept { return topic_; }

 private:
  const std::string name_;
  const std::string topic_;
  const std::string type_;
  const Decode decode_;
  const std::shared_ptr<Notices> notices_;
  std::mutex mutex_;  // of the transport's threads: one writes at a time
  Newest<State> newest_;
  std::uint64_t last_ = 0;  // of the thread that reads
  std::atomic<std::int64_t> heard_ns_{0};
};

}  // namespace robotui::rt::hal::gazebo
