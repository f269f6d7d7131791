#include "robotui/rt/supervisor/shutdown.h"

#include <poll.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {
namespace {

constexpr int kLookMs = 20;

bool areGone(const std::vector<Child*>& children) {
  bool gone = true;
  for (Child* child : children) {
    child->end();
    gone = gone && !child->isAlive();
  }
  return gone;
}

}  // namespace

void endProcesses(const std::vector<Child*>& children, std::int64_t patience_ns, Signals& signals) {
  for (Child* child : children) {
    child->socket().send("end");
  }
  const std::int64_t until = link::now() + patience_ns;
  for (bool asked_again = false; !asked_again && link::now() < until;) {
    if (areGone(children)) {
      return;
    }
    pollfd polled{signals.get(), POLLIN, 0};
    ::poll(&polled, 1, kLookMs);
    asked_again = signals.take();
  }
  for (Child* child : children) {
    child->kill();
  }
}

}  // namespace robotui::rt::supervisor
