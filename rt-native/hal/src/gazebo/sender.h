// Sends commands: the thread of real time leaves them here, an ordinary thread gives them to the transport, which locks
// and allocates.
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "joint_inbox.h"
#include "joint_output.h"

namespace robotui::rt::hal::gazebo {

class Sender {
 public:
  Sender(const config::RobotDescription& robot, const Settings& settings, Transport& transport,
         std::shared_ptr<JointInbox> states, std::shared_ptr<Notices> notices);
  ~Sender() { stop(); }
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;

  // By the thread of real time: neither waits nor allocates. While the simulator is silent nothing is sent: a robot
  // that returns must not jump to where it was before.
  void leave(std::span<const Reference> references, bool is_live) noexcept;

  // Nothing is sent any more.
  void stop() noexcept;

  // After stop(): all joints that the simulator still moves are told to hold where they are.
  void hold();

 private:
  struct Commands {
    std::uint64_t is_live;
    std::array<Reference, link::kMaxJoints> references;
  };

  void run(const std::stop_token& stop);
  void send(const Commands& commands, std::int64_t now_ns);
  void look(std::int64_t now_ns);

  std::shared_ptr<JointInbox> states_;
  std::shared_ptr<Notices> notices_;
  std::vector<JointOutput> outputs_;
  Commands next_{};  // of the thread of real time
  Newest<Commands> commands_;
  std::atomic<std::uint32_t> bell_{0};
  Sample sample_{};  // of the thread below
  std::uint64_t last_sample_ = 0;
  std::int64_t looked_ns_ = 0;
  std::int64_t unheard_ns_ = 0;  // since when a command finds no listener; 0 is none
  std::jthread thread_;
};

}  // namespace robotui::rt::hal::gazebo
