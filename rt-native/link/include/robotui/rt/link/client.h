// What a client of a running robot does: find it by name, map its memory, ask its supervisor.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/link/socket.h"

namespace robotui::rt::link {

struct Attachment {
  Segment<const StateSegment> state;
  Segment<const BoardSegment> board;
  std::vector<Segment<const HostSegment>> hosts;
};

struct Reply {
  bool ok;
  std::string text;  // behind `ok` or `error`
};

enum class Notice : std::uint8_t {
  kNone,
  kChanged,  // a segment was replaced: attach again; what is mapped stays readable
  kGone      // the supervisor is gone: reconnect
};

// For one thread at a time.
class Client {
 public:
  using Milliseconds = Socket::Milliseconds;

  // Throws SocketError with a sentence: no such robot runs, or it is another user's.
  Client(std::string robot, Milliseconds timeout);

  const std::string& robot() const noexcept { return robot_; }

  // Throws SocketError or SegmentError.
  Attachment attach(Milliseconds timeout);

  // Such as `switch homing 1`. Not ok, with a sentence, also where no reply came in time or the supervisor is gone.
  Reply request(std::string_view words, Milliseconds timeout);

  // Only for the master. False where the supervisor is gone.
  bool reference(std::span<const JointCommand> joints);

  // Waits for a notice that long; also those that came during a request.
  Notice notice(Milliseconds timeout);

  // Becomes readable when there is something for notice().
  int descriptor() const noexcept { return socket_.get(); }

  // After kGone; false where it does not run (again).
  bool reconnect(Milliseconds timeout);

 private:
  Received reply(Packet& into, Milliseconds timeout);

  std::string robot_;
  Socket socket_;
  bool changed_ = false;
};

}  // namespace robotui::rt::link
