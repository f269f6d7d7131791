// The control socket: clients of the same user, their packets, and replies that never make the supervisor wait.
#pragma once

#include <poll.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "robotui/rt/link/socket.h"

namespace robotui::rt::supervisor {

class ControlServer {
 public:
  static constexpr std::size_t kMostClients = 32;
  static constexpr int kPacketsATurn = 16;  // of one client: others come after

  // Throws link::SocketError where another instance has the place.
  explicit ControlServer(const std::filesystem::path& path);
  ~ControlServer();
  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;

  void addTo(std::vector<pollfd>& polled) const;

  // Takes new clients and hands on what came. `gone` is told of clients that left.
  void serve(const std::function<void(std::uint64_t, const link::Packet&)>& request,
             const std::function<void(std::uint64_t)>& gone);

  // To a client that does not read, it is the last one: it is dropped.
  void reply(std::uint64_t client, std::string_view text, std::span<const int> descriptors = {});
  void broadcast(std::string_view text);

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  struct Client {
    link::Socket socket;
    bool leaving = false;
  };
  void accept();
  bool hear(std::uint64_t id, Client& client, const std::function<void(std::uint64_t, const link::Packet&)>& request);

  std::filesystem::path path_;
  link::Socket listener_;
  std::map<std::uint64_t, Client> clients_;
  std::uint64_t next_id_ = 1;
};

}  // namespace robotui::rt::supervisor
