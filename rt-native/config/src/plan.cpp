#include "robotui/rt/config/plan.h"

#include <algorithm>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::config {
namespace {

constexpr const char* kOrdinaryName = "nrt";
constexpr const char* kIoName = "io";

HostPlan& hostNamed(Plan& plan, const std::string& name, HostKind kind) {
  const auto found =
      std::find_if(plan.hosts.begin(), plan.hosts.end(), [&](const HostPlan& host) { return host.name == name; });
  return found != plan.hosts.end() ? *found : plan.hosts.emplace_back(HostPlan{name, kind, {}});
}

std::uint32_t threadIn(HostPlan& host, const ThreadConfig& thread) {
  const auto found = std::find_if(host.threads.begin(), host.threads.end(),
                                  [&](const ThreadConfig& t) { return t.name == thread.name; });
  if (found != host.threads.end()) {
    return static_cast<std::uint32_t>(found - host.threads.begin());
  }
  host.threads.push_back(thread);
  return static_cast<std::uint32_t>(host.threads.size() - 1);
}

const ThreadConfig& threadOf(const RtConfig& config, const PluginConfig& plugin) {
  return *std::find_if(config.threads.begin(), config.threads.end(),
                       [&](const ThreadConfig& t) { return t.name == plugin.thread; });
}

ThreadConfig asOrdinary(ThreadConfig thread) {
  thread.scheduling = Scheduling::kOther;
  thread.priority = 0;
  return thread;
}

void add(Plan& plan, const PluginConfig& plugin, const std::string& host, HostKind kind, const ThreadConfig& thread) {
  HostPlan& in = hostNamed(plan, host, kind);
  if (in.kind != kind) {
    throw ConfigError(thread.place, "the host '" + host + "' is the name of the process of " +
                                        (kind == HostKind::kIo ? "io_plugins" : "NRTPlugins") +
                                        "; choose another one for the threads");
  }
  const std::uint32_t index = threadIn(in, thread);
  plan.plugins.push_back({plugin, static_cast<std::uint32_t>(&in - plan.hosts.data()), index});
}

void checkRoom(const Plan& plan, const RtConfig& config) {
  const auto check = [&](std::size_t there, std::size_t room, const std::string& of) {
    if (there > room) {
      throw ConfigError(Place{config.file, 0, 0},
                        "there are " + std::to_string(there) + " " + of + ", and room for " + std::to_string(room));
    }
  };
  check(plan.plugins.size(), link::kMaxPlugins, "plugins");
  check(plan.hosts.size(), link::kMaxHosts, "processes of plugins (hosts, NRTPlugins, io_plugins)");
  for (const HostPlan& host : plan.hosts) {
    check(host.threads.size(), link::kMaxThreads, "threads in the host '" + host.name + "'");
  }
}

}  // namespace

Plan plan(const RtConfig& config, const Communication& communication) {
  Plan plan;
  for (const PluginConfig& plugin : config.plugins) {
    const ThreadConfig& thread = threadOf(config, plugin);
    add(plan, plugin, thread.host, HostKind::kRealTime, thread);
  }
  for (const PluginConfig& plugin : config.nrt_plugins) {
    add(plan, plugin, kOrdinaryName, HostKind::kOrdinary, asOrdinary(threadOf(config, plugin)));
  }
  ThreadConfig handler = asOrdinary({});
  handler.name = "communication_handler";
  handler.period = communication.period;
  for (const PluginConfig& plugin : config.io_plugins) {
    if (communication.enabled) {
      add(plan, plugin, kIoName, HostKind::kIo, handler);
    }
  }
  checkRoom(plan, config);
  return plan;
}

}  // namespace robotui::rt::config
