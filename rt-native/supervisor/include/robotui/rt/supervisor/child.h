// A process that the supervisor started, and the socket to it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotui/rt/link/socket.h"

namespace robotui::rt::supervisor {

class Child {
 public:
  Child() = default;
  ~Child() { kill(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Gets `--control FD` as its last argument. `on_orphan` is sent to it when the supervisor dies. Throws
  // std::runtime_error.
  void spawn(const std::filesystem::path& program, std::vector<std::string> arguments, int on_orphan);

  bool isAlive() const noexcept { return pid_ > 0; }
  pid_t pid() const noexcept { return pid_; }
  link::Socket& socket() noexcept { return socket_; }

  // Ends it at once, with the reason that end() then gives.
  void kill(const std::string& reason);
  // Waits for its end.
  void kill() noexcept;

  // How it ended, as words behind "The process ...": nothing while it lives. What it sent before can still be received.
  std::optional<std::string> end();

 private:
  pid_t pid_ = -1;
  link::Socket socket_;
  std::string reason_;
};

// Beside this executable.
std::filesystem::path programBeside(const std::string& name);

}  // namespace robotui::rt::supervisor
