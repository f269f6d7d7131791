// The process that shows the robot in ROS, as the supervisor sees it: nothing here depends on how it is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robotui/rt/link/channels.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/supervisor/child.h"
#include "robotui/rt/supervisor/respawn.h"

namespace robotui::rt::supervisor {

class RosProcess {
 public:
  // `wanted` is the configuration's word: the master framework is ROS.
  explicit RosProcess(bool wanted);

  bool isWanted() const noexcept { return wanted_; }
  // Empty, or a sentence why it cannot be started.
  std::string lack() const;

  Child& child() noexcept { return child_; }

  // Its channels to plugins, which outlive it. Only where it is wanted.
  link::Descriptor shareChannels() const { return channels_.shareReadOnly(); }

  // `channels` are those of the hosts. Throws std::runtime_error.
  void spawn(const std::vector<std::string>& arguments, const std::vector<int>& channels, std::int64_t now_ns);

  bool isDue(std::int64_t now_ns) const noexcept;
  void alive(std::int64_t now_ns) noexcept { alive_ns_ = now_ns; }

  // Kills it where it hangs.
  void watch(std::int64_t now_ns);

  // Empty, or what the user should know: that it is not started for a while.
  std::string ended(std::int64_t now_ns);

 private:
  void resetChannels();

  bool wanted_;
  Child child_;
  RespawnPolicy respawns_;
  link::Segment<link::ChannelSegment> channels_;
  link::Header header_{};
  std::int64_t alive_ns_ = 0;
  std::int64_t rest_until_ns_ = 0;
};

}  // namespace robotui::rt::supervisor
