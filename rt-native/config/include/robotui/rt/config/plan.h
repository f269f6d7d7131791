// Which process runs what: the same answer for the supervisor, which starts the processes, and for each of them.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

enum class HostKind : std::uint8_t {
  kRealTime,  // a `host` of xbotcore_threads
  kOrdinary,  // NRTPlugins: the same plugins in ordinary threads
  kIo         // io_plugins: the communication handler
};

struct HostPlan {
  std::string name;
  HostKind kind;
  std::vector<ThreadConfig> threads;  // their order is their index
};

struct PluginPlan {
  PluginConfig plugin;
  std::uint32_t host;
  std::uint32_t thread;  // index in its host
};

struct Plan {
  std::vector<HostPlan> hosts;
  std::vector<PluginPlan> plugins;  // their order is their index on the board
};

struct Communication {
  bool enabled = true;  // --no-ch
  std::chrono::microseconds period{5000};
};

// Hosts without a plugin are left out. Throws ConfigError where the layout of the link has no room.
Plan plan(const RtConfig& config, const Communication& communication);

}  // namespace robotui::rt::config
