// Takes what the world says of itself, on the threads of the transport: whether it is paused, and how fast it goes.
#pragma once

#include <atomic>
#include <memory>

#include "messages.h"
#include "../notices.h"

namespace robotui::rt::hal::gazebo {

class WorldInbox {
 public:
  WorldInbox(std::string world, std::shared_ptr<Notices> notices)
      : world_(std::move(world)), notices_(std::move(notices)) {}

  // By the transport.
  void hear(std::string_view type, Bytes message);

  // Neither waits nor allocates. When the world said that it is paused; 0 where it runs, or says nothing.
  std::int64_t pausedNs() const noexcept { return paused_ns_.load(std::memory_order_acquire); }

 private:
  void speed(const WorldState& state, std::int64_t now_ns);

  const std::string world_;
  const std::shared_ptr<Notices> notices_;
  std::atomic<std::int64_t> paused_ns_{0};
  std::atomic<int> slow_{0};  // how often in turn it said so
};

}  // namespace robotui::rt::hal::gazebo
