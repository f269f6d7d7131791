#include "robotui/rt/link/client.h"

#include <cerrno>

#include <unistd.h>

namespace robotui::rt::link {

namespace {

using Clock = std::chrono::steady_clock;

Socket connectTo(const std::string& robot, Socket::Milliseconds timeout) {
  const std::filesystem::path path = socketPath(robot);
  if (!std::filesystem::exists(path))
    throw SocketError("No robot '" + robot + "' runs here: there is no " + path.string() + ".");
  Socket socket = Socket::connect(path, timeout);
  if (socket.peer().uid != ::getuid()) throw SocketError("The robot '" + robot + "' was started by another user.");
  return socket;
}

}  // namespace

Client::Client(std::string robot, Milliseconds timeout)
    : robot_(std::move(robot)), socket_(connectTo(robot_, timeout)) {}

// Notices may come in front of the reply.
Received Client::reply(Packet& into, Milliseconds timeout) {
  const auto deadline = Clock::now() + timeout;
  while (true) {
    const auto left = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
    const Received received = socket_.receive(into, std::max(left, Milliseconds(0)));
    if (received == Received::kClosed) socket_.close();
    if (received != Received::kPacket || into.verb() != "changed") return received;
    changed_ = true;
  }
}

Reply Client::request(std::string_view words, Milliseconds timeout) {
  if (!socket_.isOpen() || !socket_.send(words)) {
    socket_.close();
    return {false, "The robot '" + robot_ + "' is gone."};
  }
  Packet packet;
  const Received received = reply(packet, timeout);
  if (received == Received::kPacket) return {packet.verb() == "ok", std::string(packet.rest())};
  // A reply that came later would be taken for that of the next request.
  socket_.close();
  return {false, received == Received::kTimeout ? "The robot '" + robot_ + "' did not answer in time."
                                                : "The robot '" + robot_ + "' is gone."};
}

Attachment Client::attach(Milliseconds timeout) {
  changed_ = false;
  Packet packet;
  if (!socket_.isOpen() || !socket_.send("attach")) throw SocketError("The robot '" + robot_ + "' is gone.");
  if (reply(packet, timeout) != Received::kPacket) {
    socket_.close();
    throw SocketError("The robot '" + robot_ + "' did not answer to 'attach'.");
  }
  if (packet.verb() != "attached") throw SocketError(std::string(packet.rest()));
  if (packet.descriptors.size() < 2) throw SocketError("The robot '" + robot_ + "' gave no memory away.");
  Attachment result;
  result.state = Segment<const StateSegment>::open(std::move(packet.descriptors[0]));
  result.board = Segment<const BoardSegment>::open(std::move(packet.descriptors[1]));
  for (std::size_t i = 2; i < packet.descriptors.size(); ++i) {
    result.hosts.push_back(Segment<const HostSegment>::openAsItIs(std::move(packet.descriptors[i])));
  }
  return result;
}

bool Client::reference(std::span<const JointCommand> joints) {
  const auto bytes = std::as_bytes(joints);
  std::string text("reference\0", 10);
  text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return socket_.isOpen() && socket_.send(text);
}

Notice Client::notice(Milliseconds timeout) {
  if (std::exchange(changed_, false)) return Notice::kChanged;
  if (!socket_.isOpen()) return Notice::kGone;
  Packet packet;
  switch (socket_.receive(packet, timeout)) {
    case Received::kTimeout: return Notice::kNone;
    case Received::kPacket: return packet.verb() == "changed" ? Notice::kChanged : Notice::kNone;
    case Received::kClosed: break;
  }
  socket_.close();
  return Notice::kGone;
}

bool Client::reconnect(Milliseconds timeout) {
  try {
    socket_ = connectTo(robot_, timeout);
    changed_ = false;
    return true;
  } catch (const SocketError&) {
    return false;
  }
}

}  // namespace robotui::rt::link
