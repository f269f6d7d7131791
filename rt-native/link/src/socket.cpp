#include "robotui/rt/link/socket.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace robotui::rt::link {

namespace {

constexpr int kSendTimeoutMs = 1000;
constexpr std::string_view kSeparators(" \0", 2);

[[noreturn]] void fail(const std::string& what) { throw SocketError(what + ": " + std::strerror(errno) + "."); }

Descriptor make() {
  Descriptor descriptor(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  if (!descriptor.isOpen()) fail("A control socket cannot be made");
  return descriptor;
}

sockaddr_un addressOf(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.native().size() >= sizeof(address.sun_path))
    throw SocketError("The path " + path.string() + " is too long for a socket.");
  std::memcpy(address.sun_path, path.c_str(), path.native().size());
  return address;
}

int connectTo(const Descriptor& socket, const sockaddr_un& address) noexcept {
  return ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address));
}

// True where it can be done now; hang-up counts, since the next call then says so.
bool waitFor(int fd, short events, int timeout_ms) noexcept {
  pollfd poll{fd, events, 0};
  int result;
  do {
    result = ::poll(&poll, 1, timeout_ms);
  } while (result < 0 && errno == EINTR);
  return result > 0;
}

// Room for the descriptors of one packet.
union DescriptorMessage {
  cmsghdr align;
  std::array<char, CMSG_SPACE(sizeof(int) * kMaxDescriptors)> bytes;
};

void attachDescriptors(msghdr& message, DescriptorMessage& control, std::span<const int> descriptors) noexcept {
  message.msg_control = control.bytes.data();
  message.msg_controllen = CMSG_SPACE(descriptors.size_bytes());
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(descriptors.size_bytes());
  std::memcpy(CMSG_DATA(header), descriptors.data(), descriptors.size_bytes());
}

// Whatever came is owned first, so that nothing leaks where the packet is refused.
std::vector<Descriptor> takeDescriptors(msghdr& message) {
  std::vector<Descriptor> result;
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < count; ++i) {
      int fd;
      std::memcpy(&fd, CMSG_DATA(header) + i * sizeof(int), sizeof(int));
      result.emplace_back(fd);
    }
  }
  return result;
}

}  // namespace

// Numbers follow a zero byte, words a space.
std::string_view Packet::verb() const noexcept {
  const std::string_view all(text);
  return all.substr(0, all.find_first_of(kSeparators));
}

std::string_view Packet::rest() const noexcept {
  const std::string_view all(text);
  const std::size_t separator = all.find_first_of(kSeparators);
  return separator == std::string_view::npos ? std::string_view() : all.substr(separator + 1);
}

std::pair<Socket, Socket> Socket::pair() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
    fail("A pair of control sockets cannot be made");
  return {Socket(Descriptor(ends[0])), Socket(Descriptor(ends[1]))};
}

Socket Socket::listen(const std::filesystem::path& path) {
  const sockaddr_un address = addressOf(path);
  if (connectTo(make(), address) == 0)
    throw SocketError("Another process already listens on " + path.string() + ": end it first.");
  if (errno == ECONNREFUSED) ::unlink(path.c_str());
  Descriptor socket = make();
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    fail("Cannot listen on " + path.string());
  if (::listen(socket.get(), 16) != 0) fail("Cannot listen on " + path.string());
  return Socket(std::move(socket));
}

Socket Socket::connect(const std::filesystem::path& path, Milliseconds timeout) {
  Descriptor socket = make();
  const timeval limit{timeout.count() / 1000, static_cast<suseconds_t>(timeout.count() % 1000 * 1000)};
  ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &limit,
               sizeof(limit));  // a full queue of listen() is what blocks here
  if (connectTo(socket, addressOf(path)) != 0) fail("Cannot connect to " + path.string());
  return Socket(std::move(socket));
}

Socket Socket::accept(Milliseconds timeout) const {
  if (!waitFor(get(), POLLIN, static_cast<int>(timeout.count()))) return {};
  return Socket(Descriptor(::accept4(get(), nullptr, nullptr, SOCK_CLOEXEC)));
}

bool Socket::send(std::string_view text, std::span<const int> descriptors) const noexcept {
  if (text.size() > kMaxPacket || descriptors.size() > kMaxDescriptors) return false;
  iovec part{const_cast<char*>(text.data()), text.size()};
  DescriptorMessage control{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (!descriptors.empty()) attachDescriptors(message, control, descriptors);
  if (!waitFor(get(), POLLOUT, kSendTimeoutMs)) return false;
  ssize_t sent;
  do {
    sent = ::sendmsg(get(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
  } while (sent < 0 && errno == EINTR);
  return sent == static_cast<ssize_t>(text.size());
}

Received Socket::receive(Packet& into, Milliseconds timeout) const {
  into.descriptors.clear();
  if (!waitFor(get(), POLLIN, static_cast<int>(timeout.count()))) return Received::kTimeout;
  into.text.resize(kMaxPacket);
  iovec part{into.text.data(), into.text.size()};
  DescriptorMessage control{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.bytes.data();
  message.msg_controllen = control.bytes.size();
  ssize_t size;
  do {
    size = ::recvmsg(get(), &message, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  into.descriptors = takeDescriptors(message);
  into.text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  const bool whole = size > 0 && (message.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) == 0;
  return whole ? Received::kPacket : Received::kClosed;
}

Peer Socket::peer() const {
  ucred credentials{};
  socklen_t size = sizeof(credentials);
  if (::getsockopt(get(), SOL_SOCKET, SO_PEERCRED, &credentials, &size) != 0)
    fail("Who is at the other end cannot be told");
  return {credentials.pid, credentials.uid};
}

void Socket::inheritable() const {
  if (::fcntl(get(), F_SETFD, 0) != 0) fail("A control socket cannot be passed on");
}

}  // namespace robotui::rt::link
