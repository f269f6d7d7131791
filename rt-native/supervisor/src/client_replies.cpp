#include "robotui/rt/supervisor/client_replies.h"

namespace robotui::rt::supervisor {

void ClientReplies::reply(std::uint64_t client, const std::string& text, std::span<const int> descriptors) {
  board_.publish();
  server_.reply(client, text, descriptors);
}

void ClientReplies::answer(std::uint64_t client, const std::string& objection) {
  reply(client, objection.empty() ? "ok" : "error " + objection);
}

void ClientReplies::announceChange() {
  board_.publish();
  server_.broadcast("changed");
}

}  // namespace robotui::rt::supervisor
