// The three topics of one joint. For one ordinary thread.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "../one_way.h"
#include "topics.h"
#include "transport.h"

namespace robotui::rt::hal::gazebo {

class JointOutput {
 public:
  JointOutput(Transport& transport, const Topics& topics, const TopicPatterns& patterns,
              const config::JointDescription& joint);

  // Sends what is another number than the one before, and each one again after a while: whoever begins to listen gets
  // it.
  void send(const Command& command, std::int64_t now_ns);

  // Joints that follow a velocity or an effort are told zero of it, and to stay at `position` where they follow
  // positions, too.
  void hold(double position, std::int64_t now_ns);

  // Asks the transport who listens: not for every cycle.
  void look();
  bool takesEffort() const noexcept { return listened_[index(Way::kEffort)]; }

  // The topic of the last command where nobody listens to it; nullptr where all is well.
  const std::string* unheard() const noexcept;

  const std::string& name() const noexcept { return name_; }
  double mostEffort() const noexcept { return most_effort_; }

 private:
  static std::size_t index(Way way) noexcept { return static_cast<std::size_t>(way) - 1; }
  void leave(Way way);

  std::string name_;
  double most_effort_;
  std::array<std::string, 3> topics_;
  std::array<std::unique_ptr<NumberOutput>, 3> outputs_;
  std::array<bool, 3> listened_{};
  Command last_{Way::kNone, 0};
  std::int64_t sent_ns_ = 0;
};

}  // namespace robotui::rt::hal::gazebo
