// Calls that wait in threads of ROS for what a plugin answers in its control loop.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::ros_bridge {

struct CallAnswer {
  bool succeeded;
  std::vector<std::uint8_t> bytes;
};

class PendingCalls {
 public:
  // Numbers of an earlier process do not come again soon.
  std::uint32_t expect() {
    const std::scoped_lock lock(mutex_);
    waiting_[++number_];
    return number_;
  }

  std::optional<CallAnswer> await(std::uint32_t number, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    came_.wait_for(lock, patience, [&] { return waiting_[number].has_value(); });
    std::optional<CallAnswer> answer = std::move(waiting_[number]);
    waiting_.erase(number);
    return answer;
  }

  // Of a call that nobody waits for it is nothing.
  void settle(std::uint32_t number, CallAnswer answer) {
    const std::scoped_lock lock(mutex_);
    const auto found = waiting_.find(number);
    if (found == waiting_.end()) return;
    found->second = std::move(answer);
    came_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::map<std::uint32_t, std::optional<CallAnswer>> waiting_;
  std::uint32_t number_ = static_cast<std::uint32_t>(link::now() / link::kMillisecond);
};

}  // namespace robotui::rt::ros_bridge
