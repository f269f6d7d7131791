// The robot as a client of its link sees it: attached again whenever it went and came.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/client.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::ros_bridge {

// States and references: for one thread.
class Robot {
 public:
  Robot(std::string name, std::size_t joints);

  // Attaches where it must; never waits long for a robot that is not there.
  void keep();

  // A state that was not had before.
  bool sense();
  const link::FrameData& frame() const noexcept { return *frame_; }
  std::span<const link::JointState> joints() const noexcept { return {frame_->joints.data(), joints_}; }

  // Empty, or why these references do not count. Becomes the master with the first, and remains it while they come.
  std::string reference(std::span<const link::JointCommand> commands);

 private:
  void attach();

  std::string name_;
  std::size_t joints_;
  std::unique_ptr<link::FrameData> frame_;
  std::unique_ptr<link::Client> client_;
  link::Attachment attachment_;
  std::optional<link::StateReader> reader_;
  std::int64_t try_again_ns_ = 0;
  std::int64_t referenced_ns_ = 0;
};

// Requests, for any thread: one at a time, over a connection of its own.
class Requests {
 public:
  explicit Requests(std::string robot) : name_(std::move(robot)) {}
  link::Reply ask(const std::string& words);

 private:
  std::string name_;
  std::mutex mutex_;
  std::unique_ptr<link::Client> client_;
};

}  // namespace robotui::rt::ros_bridge
