#include "command_plan.h"

#include <algorithm>

namespace robotui::rt::hal {

namespace {

constexpr std::chrono::nanoseconds kToStart = std::chrono::seconds(1);

}  // namespace

CommandPlan commandPlan(const config::Plan& plan, std::chrono::nanoseconds period) {
  CommandPlan result;
  std::vector<std::uint32_t> first;  // thread of a host, in the list of all
  for (std::uint32_t host = 0; host < plan.hosts.size(); ++host) {
    first.push_back(static_cast<std::uint32_t>(result.threads.size()));
    for (std::uint32_t i = 0; i < plan.hosts[host].threads.size(); ++i) {
      const auto every = std::chrono::nanoseconds(plan.hosts[host].threads[i].period) / period;
      result.threads.push_back({host, i, std::max<std::uint64_t>(1, static_cast<std::uint64_t>(every))});
    }
  }
  result.start_cycles = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kToStart / period));
  for (const config::PluginPlan& plugin : plan.plugins)
    result.thread_of_plugin.push_back(first[plugin.host] + plugin.thread);
  return result;
}

}  // namespace robotui::rt::hal
