// Takes the states of joints on the threads of the transport, and keeps the newest for the thread of real time.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "messages.h"
#include "newest.h"
#include "../notices.h"
#include "stamp_gate.h"

namespace robotui::rt::hal::gazebo {

// What came until the first state that has all joints.
struct FirstState {
  bool is_there = false;
  std::string other_type;          // of what came instead, empty where nothing did
  std::string missing_joint;       // of the robot, in a state that came; empty where none is missing
  std::vector<std::string> names;  // of the joints in that state
};

class JointInbox {
 public:
  // A state after `silence_ns` without one is taken whatever its time is.
  JointInbox(std::vector<std::string> joints, std::string topic, std::int64_t silence_ns,
             std::shared_ptr<Notices> notices);

  // By the transport.
  void hear(std::string_view type, Bytes message);

  // By an ordinary thread: returns when a state came, with all joints or not, or the time is over.
  FirstState awaitFirst(std::int64_t most_ns);

  // By any one thread with its own `last`, as all below: neither waits nor allocates.
  link::Read sample(Sample& into, std::uint64_t& last) const noexcept { return newest_.read(into, last); }

  // When simulated time went on for the last time; 0 is never.
  std::int64_t heardNs() const noexcept { return heard_ns_.load(std::memory_order_acquire); }

  // The joint of which the last state says what is no number, or -1.
  int unsoundJoint() const noexcept { return unsound_.load(std::memory_order_acquire); }

  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }
  const std::string& topic() const noexcept { return topic_; }

 private:
  void drop() noexcept { dropped_.fetch_add(1, std::memory_order_relaxed); }
  void otherType(std::string_view type);
  void refuse(JointsReading reading, Bytes message);
  void take(std::int64_t now_ns);
  void went(Stamp stamp, std::int64_t now_ns);

  const std::vector<std::string> joints_;
  const std::string topic_;
  const std::shared_ptr<Notices> notices_;
  JointIndex index_;

  std::mutex mutex_;  // of the transport's threads: one writes at a time
  std::condition_variable changed_;
  FirstState first_;
  StampGate gate_;
  Sample next_{};

  Newest<Sample> newest_;
  std::atomic<std::int64_t> heard_ns_{0};
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<int> unsound_{-1};
};

}  // namespace robotui::rt::hal::gazebo
