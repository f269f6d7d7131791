// The socket to the supervisor that started this process, where one did: memory for plugins, lines for the log, and
// signs of life.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "robotui/rt/link/channels.h"
#include "robotui/rt/link/socket.h"

namespace robotui::rt::ros_bridge {

class Supervision {
 public:
  // Without a descriptor (-1) there is no supervisor: lines go to stderr, and plugins have no topics.
  explicit Supervision(int control);

  void say(const char* level, const std::string& line);
  // False where the supervisor is gone or wants the end.
  bool goesOn();

  link::ChannelSegment* own() const noexcept { return own_.get(); }
  std::vector<const link::ChannelSegment*> hosts() const;

 private:
  link::Socket socket_;
  std::mutex mutex_;
  link::Segment<link::ChannelSegment> own_;
  std::vector<link::Segment<const link::ChannelSegment>> hosts_;
  std::int64_t alive_ns_ = 0;
};

}  // namespace robotui::rt::ros_bridge
