#include "robotui/rt/supervisor/ros_process.h"

#include <signal.h>
#include <unistd.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {
namespace {

constexpr const char* kProgram = "robotui-rt-ros";
constexpr std::int64_t kSilentNs = 15 * link::kSecond;
constexpr std::int64_t kRestNs = 30 * link::kSecond;  // after it died again and again: the ROS around it may be mended

}  // namespace

RosProcess::RosProcess(bool wanted) : wanted_(wanted) {
  if (!wanted) return;
  channels_ = link::Segment<link::ChannelSegment>::create(1);
  header_ = channels_->header;
}

std::string RosProcess::lack() const {
  if (!wanted_ || ::access(programBeside(kProgram).c_str(), X_OK) == 0) return {};
  return "The configuration names ROS as the master framework, but robotui-rt-ros is not built: the robot is not seen "
         "in ROS. Install libroscpp-dev, "
         "libstd-srvs-dev, libsensor-msgs-dev, libgeometry-msgs-dev, libtf2-msgs-dev, python3-gencpp and "
         "python3-genpy, and build again.";
}

void RosProcess::spawn(const std::vector<std::string>& arguments, const std::vector<int>& channels,
                       std::int64_t now_ns) {
  resetChannels();
  alive_ns_ = now_ns;
  child_.spawn(programBeside(kProgram), arguments, SIGTERM);
  const link::Descriptor own = channels_.shareWritable();
  std::vector<int> given{own.get()};
  given.insert(given.end(), channels.begin(), channels.end());
  child_.socket().send("begin", given);
}

// Plugins have mapped it: nothing of the process before may stay.
void RosProcess::resetChannels() {
  for (link::ChannelSlot& slot : channels_->slots) {
    slot.id.store(0, std::memory_order_release);
    slot.name.fill(0);
  }
  channels_->header = header_;
}

bool RosProcess::isDue(std::int64_t now_ns) const noexcept {
  return wanted_ && !child_.isAlive() && now_ns >= respawns_.startAt() && now_ns >= rest_until_ns_;
}

void RosProcess::watch(std::int64_t now_ns) {
  if (child_.isAlive() && now_ns - alive_ns_ > kSilentNs) {
    child_.kill("it did not answer any more");
  }
}

std::string RosProcess::ended(std::int64_t now_ns) {
  respawns_.ended(now_ns);
  if (!respawns_.isGivenUp()) return {};
  respawns_.reset();
  rest_until_ns_ = now_ns + kRestNs;
  return "The ROS process died again and again: it is started again in half a minute.";
}

}  // namespace robotui::rt::supervisor
