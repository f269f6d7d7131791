// The blocks of the configuration, each read by itself.
#pragma once

#include "robotui/rt/config/reader.h"

namespace robotui::rt::config {

HalConfig readHal(const Reader& top, const Overrides& overrides, std::vector<std::string>& warnings);

// `following_error` and `following_time` of the HAL, for the joints of the robot, which is known.
void readFollowing(const Reader& top, RtConfig& into);

// `emergency_stops` of the HAL, whose inputs may be those of joints, which are known.
void readEmergencyStops(const Reader& top, RtConfig& into);

// `xbotcore_threads`; without it one thread of the HAL's period, named as XBot users know it.
std::vector<ThreadConfig> readThreads(const Reader& top, const HalConfig& hal, const Overrides& overrides,
                                      std::vector<std::string>& warnings);

// `xbotcore_plugins`, `XBotRTPlugins` and `NRTPlugins` into the lists of `into`, whose threads are known.
void readPlugins(const Reader& top, RtConfig& into);

// What only all together can tell: sizes, priorities, cores.
void checkLimits(const Reader& top, const RtConfig& config);

// `runtime` of a block whose `sched` is deadline. Throws where prio or core_id are written beside it.
double readRuntime(const Reader& block, double usual);

// The core of a `core_id`: one on which this process may run.
std::optional<int> readCore(const Reader& block);

// Behind the plugins, which it names.
void readSwitchGroups(const Reader& top, RtConfig& into);

// A name that can be said on a command line.
void mustBeWord(const Reader& at, const std::string& word);

}  // namespace robotui::rt::config
