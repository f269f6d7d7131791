// Pushes of a simulated robot that clients ask for: each ends after its time, or with the client.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/push.h"
#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/hal_process.h"
#include "robotui/rt/supervisor/log_file.h"

namespace robotui::rt::supervisor {

class PushRequests {
 public:
  PushRequests(const config::RobotDescription& robot, HalProcess& hal, ClientReplies& replies, LogFile& log)
      : robot_(robot), hal_(hal), replies_(replies), log_(log) {}

  // "JOINT EFFORT SECONDS" or "LINK X Y Z SECONDS"; answered when the HAL has said whether it does it. Another one of
  // the same client takes the place of the one before.
  void push(std::uint64_t client, std::string_view words, std::int64_t now_ns);

  // What the HAL said: "NUMBER" where it does it, or "NUMBER SENTENCE".
  void answered(std::string_view words);
  void halEnded();

  // The client is gone, and its push ends.
  void forget(std::uint64_t client);

 private:
  struct Place {
    std::optional<std::uint64_t> client;
    link::Push push;
    std::int64_t until_ns = 0;
    bool waits = false;  // for the word of the HAL
  };
  // Throws std::invalid_argument with a sentence.
  link::Push pushOf(std::string_view words) const;
  Place* placeFor(std::uint64_t client, std::int64_t now_ns);

  const config::RobotDescription& robot_;
  HalProcess& hal_;
  ClientReplies& replies_;
  LogFile& log_;
  std::array<Place, link::kMostPushes> places_{};
};

}  // namespace robotui::rt::supervisor
