#include "robotui/rt/supervisor/control_server.h"

#include <unistd.h>

namespace robotui::rt::supervisor {
namespace {

constexpr std::chrono::milliseconds kAtOnce{0};

bool isReady(int fd, short events) {
  pollfd polled{fd, events, 0};
  return ::poll(&polled, 1, 0) > 0 && (polled.revents & events) != 0;
}

}  // namespace

ControlServer::ControlServer(const std::filesystem::path& path) : path_(path), listener_(link::Socket::listen(path)) {}

ControlServer::~ControlServer() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void ControlServer::addTo(std::vector<pollfd>& polled) const {
  polled.push_back({listener_.get(), POLLIN, 0});
  for (const auto& [id, client] : clients_) {
    polled.push_back({client.socket.get(), POLLIN, 0});
  }
}

void ControlServer::serve(const std::function<void(std::uint64_t, const link::Packet&)>& request,
                          const std::function<void(std::uint64_t)>& gone) {
  for (int i = 0; i < kPacketsATurn && isReady(listener_.get(), POLLIN); ++i) {
    accept();
  }
  for (auto at = clients_.begin(); at != clients_.end();) {
    if (hear(at->first, at->second, request)) {
      ++at;
      continue;
    }
    gone(at->first);
    at = clients_.erase(at);
  }
}

void ControlServer::accept() {
  link::Socket socket = listener_.accept(kAtOnce);
  if (!socket.isOpen()) {
    return;
  }
  if (socket.peer().uid != ::getuid()) {
    socket.send("error This robot was started by another user: only that one may control it.");
  } else if (clients_.size() >= kMostClients) {
    socket.send("error " + std::to_string(kMostClients) + " clients are connected: there is no room for another one.");
  } else {
    clients_.emplace(next_id_++, Client{std::move(socket)});
  }
}

// False where it is gone.
bool ControlServer::hear(std::uint64_t id, Client& client,
                         const std::function<void(std::uint64_t, const link::Packet&)>& request) {
  for (int i = 0; i < kPacketsATurn && !client.leaving; ++i) {
    if (!isReady(client.socket.get(), POLLIN | POLLHUP | POLLERR)) {
      return true;
    }
    link::Packet packet;
    switch (client.socket.receive(packet, kAtOnce)) {
      case link::Received::kPacket: request(id, packet); break;
      case link::Received::kTimeout: return true;
      case link::Received::kClosed: return false;
    }
  }
  return !client.leaving;
}

void ControlServer::reply(std::uint64_t id, std::string_view text, std::span<const int> descriptors) {
  const auto found = clients_.find(id);
  if (found == clients_.end() || found->second.leaving) {
    return;
  }
  Client& client = found->second;
  client.leaving =
      !isReady(client.socket.get(), POLLOUT) || !client.socket.send(text.substr(0, link::kMaxPacket), descriptors);
}

void ControlServer::broadcast(std::string_view text) {
  for (const auto& [id, client] : clients_) {
    reply(id, text);
  }
}

}  // namespace robotui::rt::supervisor
