#include <map>

#include "blocks.h"
#include "robotui/rt/link/deadline.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::config {
namespace {

void checkThread(const ThreadConfig& thread, const HalConfig& hal) {
  if (thread.scheduling == Scheduling::kDeadline && hal.priority != link::kByDeadline)
    throw ConfigError(thread.place, "the thread '" + thread.name +
                                        "' has sched: deadline, which goes before the HAL's priority; write "
                                        "HALInterface: {sched: deadline}, too");
  if (thread.scheduling != Scheduling::kFifo || thread.priority < hal.priority) return;
  throw ConfigError(thread.place, "the thread '" + thread.name + "' has the priority " +
                                      std::to_string(thread.priority) + "; it must be below the HAL's, " +
                                      std::to_string(hal.priority) + ", or a plugin could stop the robot's own loop");
}

}  // namespace

void checkLimits(const Reader& top, const RtConfig& config) {
  std::map<std::string, std::size_t> hosts;
  for (const auto& thread : config.threads) {
    checkThread(thread, config.hal);
    if (thread.name.size() >= link::kNameLength || thread.host.size() >= link::kNameLength) {
      throw ConfigError(thread.place, "the thread's or its host's name is longer than 63 bytes");
    }
    if (++hosts[thread.host] > link::kMaxThreads) {
      throw ConfigError(thread.place, "the host '" + thread.host + "' has more than " +
                                          std::to_string(link::kMaxThreads) + " threads; give some another `host`");
    }
  }
  if (hosts.size() > link::kMaxHosts)
    top.fail("xbotcore_threads has more than " + std::to_string(link::kMaxHosts) + " hosts");
  const auto plugins = config.plugins.size() + config.io_plugins.size() + config.nrt_plugins.size();
  if (plugins > link::kMaxPlugins) top.fail("there are more than " + std::to_string(link::kMaxPlugins) + " plugins");
}

}  // namespace robotui::rt::config
