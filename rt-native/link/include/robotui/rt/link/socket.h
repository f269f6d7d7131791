// The control socket: SEQPACKET on this machine, packets with file descriptors. Not for real-time threads.
#pragma once

#include <chrono>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/link/descriptor.h"

namespace robotui::rt::link {

inline constexpr std::size_t kMaxPacket = std::size_t{64} * 1024;
inline constexpr std::size_t kMaxDescriptors = 16;

class SocketError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Packet {
  std::string text;
  std::vector<Descriptor> descriptors;

  // The first word, and what follows the space (or zero byte) behind it.
  std::string_view verb() const noexcept;
  std::string_view rest() const noexcept;
};

enum class Received : std::uint8_t {
  kPacket,
  kTimeout,
  kClosed  // the other side is gone, or sent what no packet of ours can be
};

// Who is at the other end, as the kernel says.
struct Peer {
  int pid;
  unsigned uid;
};

class Socket {
 public:
  using Milliseconds = std::chrono::milliseconds;

  Socket() = default;
  explicit Socket(Descriptor descriptor) noexcept : descriptor_(std::move(descriptor)) {}

  // Two ends; neither is inherited by exec unless inheritable() is called.
  static std::pair<Socket, Socket> pair();

  // Replaces a socket that nobody listens on any more. Throws SocketError, also where somebody does.
  static Socket listen(const std::filesystem::path& path);
  static Socket connect(const std::filesystem::path& path, Milliseconds timeout);

  // A closed socket where nobody came in time.
  Socket accept(Milliseconds timeout) const;

  // False where the other side is gone, or does not read for a second. Never a SIGPIPE.
  bool send(std::string_view text, std::span<const int> descriptors = {}) const noexcept;

  // A negative time waits for ever.
  Received receive(Packet& into, Milliseconds timeout) const;

  Peer peer() const;
  bool isOpen() const noexcept { return descriptor_.isOpen(); }
  int get() const noexcept { return descriptor_.get(); }
  void inheritable() const;
  void close() noexcept { descriptor_.reset(); }

 private:
  Descriptor descriptor_;
};

// Where the supervisor of a robot listens. The folder is made with mode 0700; throws SocketError where it belongs to
// another user, is open to others, or the name cannot be a file's.
std::filesystem::path socketFolder();
std::filesystem::path socketPath(std::string_view robot);

}  // namespace robotui::rt::link
