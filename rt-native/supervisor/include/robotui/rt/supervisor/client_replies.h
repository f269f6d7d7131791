// What clients are told: replies, and that segments were replaced. The board is published before, so that who reads it
// after a reply sees what that says.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "robotui/rt/supervisor/board_publisher.h"
#include "robotui/rt/supervisor/control_server.h"

namespace robotui::rt::supervisor {

class ClientReplies {
 public:
  ClientReplies(BoardPublisher& board, ControlServer& server) : board_(board), server_(server) {}

  void reply(std::uint64_t client, const std::string& text, std::span<const int> descriptors = {});

  // "ok", or "error OBJECTION".
  void answer(std::uint64_t client, const std::string& objection);

  // To all: a segment was replaced.
  void announceChange();

 private:
  BoardPublisher& board_;
  ControlServer& server_;
};

}  // namespace robotui::rt::supervisor
