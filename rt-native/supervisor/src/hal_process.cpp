#include "robotui/rt/supervisor/hal_process.h"

#include <signal.h>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::int64_t kStuckNs = link::kSecond;
constexpr std::int64_t kOrdinaryStuckNs = 5 * link::kSecond;  // in an ordinary thread it may wait for others
constexpr std::int64_t kOpeningNs = 60 * link::kSecond;

}  // namespace

// An orphaned HAL is asked, not killed: it moves the robot into its safe state before it goes.
void HalProcess::spawn(const std::vector<std::string>& arguments, const std::vector<int>& segments) {
  failure_.clear();
  progress_ns_ = link::now();
  child_.spawn(programBeside("robotui-rt-hal"), arguments, SIGTERM);
  child_.socket().send("begin", segments);
}

void HalProcess::handle(link::Packet& packet) {
  if (packet.verb() == "failed") {
    failure_ = packet.rest();
  } else if (packet.verb() == "drives") {
    drives_ = packet.rest();
  } else if (packet.verb() == "state" && !packet.descriptors.empty()) {
    state_ = link::Segment<const link::StateSegment>::open(std::move(packet.descriptors.front()));
    progress_ns_ = link::now();
    last_cycle_ = 0;
  }
}

void HalProcess::watch(std::int64_t now_ns) {
  if (!child_.isAlive()) {
    return;
  }
  if (const std::uint64_t now = cycle(); now != last_cycle_) {
    last_cycle_ = now;
    progress_ns_ = now_ns;
  }
  if (now_ns - progress_ns_ > patience()) {
    child_.kill(isOpen() ? "it did not cycle any more" : "it did not open the robot within a minute");
  }
}

std::int64_t HalProcess::patience() const noexcept {
  if (!isOpen()) {
    return kOpeningNs;
  }
  return link::relaxedLoad(state_->loop.priority) > 0 ? kStuckNs : kOrdinaryStuckNs;
}

void HalProcess::ended(std::int64_t now_ns) {
  state_ = {};
  drives_.clear();
  respawns_.ended(now_ns);
}

std::int64_t HalProcess::period() const noexcept { return state_ ? link::relaxedLoad(state_->loop.period_ns) : 0; }

}  // namespace robotui::rt::supervisor
