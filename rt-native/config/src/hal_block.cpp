#include "blocks.h"
#include "robotui/rt/link/deadline.h"

namespace robotui::rt::config {
namespace {

constexpr std::chrono::microseconds kShortest{100};
constexpr std::chrono::microseconds kLongest{1000000};

// A bare name is looked for where libraries are; a path is relative to the configuration.
std::filesystem::path libraryOf(const Reader& value) {
  std::filesystem::path path = value.text();
  if (!path.has_parent_path() || path.is_absolute()) return path;
  return (value.place().file.parent_path() / path).lexically_normal();
}

void readType(const Reader& block, HalConfig& hal) {
  if (const auto file = block.find("lib_file")) {
    hal.lib_file = libraryOf(*file);
    hal.type = "library";
  }
  hal.lib_name = block.textOr("lib_name", "");
  if (const auto type = block.find("type"))
    hal.type = type->oneOf({"dummy", "mujoco", "gazebo", "udp", "canopen", "ethercat", "library"});
  if (hal.type == "library" && hal.lib_file.empty())
    block.fail("has the type library, but no 'lib_file'; write lib_file: libMyHal.so");
}

void readSafety(const Reader& block, HalConfig& hal) {
  hal.misses_before_safe = static_cast<int>(block.wholeOr("misses_before_safe", hal.misses_before_safe, 1, 1000));
  hal.deadline = block.realOr("deadline", hal.deadline, 0.05, 0.95);
  hal.safe_damping = block.realOr("safe_damping", hal.safe_damping, 0, 1e6);
  if (const auto law = block.find("safe_law")) {
    hal.safe_law = law->oneOf({"damping", "gravity"}) == "gravity" ? SafeLaw::kGravity : SafeLaw::kDamping;
  }
}

void readScheduling(const Reader& block, HalConfig& hal) {
  hal.period =
      std::chrono::microseconds(block.wholeOr("period_us", hal.period.count(), kShortest.count(), kLongest.count()));
  const auto sched = block.find("sched");
  if (sched && sched->oneOf({"fifo", "deadline"}) == "deadline") {
    hal.priority = link::kByDeadline;
    hal.runtime = readRuntime(block, hal.runtime);
  } else {
    hal.priority = static_cast<int>(block.wholeOr("prio", hal.priority, 2, 98));
    hal.core = readCore(block);
  }
  hal.wake_latency_us = static_cast<int>(block.wholeOr("cpu_dma_latency_us", hal.wake_latency_us, -1, 1'000'000));
}

void warnOfOldNames(const Reader& block, std::vector<std::string>& warnings) {
  for (const char* key : {"IJoint", "IEndEffectors", "ISensors"}) {
    if (const auto old = block.find(key)) {
      warnings.emplace_back(
          ConfigError(old->place(), old->path() + " has no effect: a HAL here is one library for joints and sensors")
              .what());
    }
  }
}

void applyOverrides(const Overrides& overrides, HalConfig& hal) {
  if (overrides.dummy) {
    hal.type = "dummy";
    hal.lib_file.clear();
    hal.params = YAML::Node(YAML::NodeType::Map);
  }
  if (!overrides.period) return;
  if (*overrides.period < kShortest || *overrides.period > kLongest) {
    throw ConfigError(
        {}, "--period " + std::to_string(overrides.period->count()) + ": expected microseconds from 100 to 1000000");
  }
  hal.period = *overrides.period;
}

}  // namespace

HalConfig readHal(const Reader& top, const Overrides& overrides, std::vector<std::string>& warnings) {
  HalConfig hal;
  hal.params = YAML::Node(YAML::NodeType::Map);
  hal.place = top.place();
  if (const auto block = top.find("HALInterface")) {
    block->knows({"type",
                  "lib_file",
                  "lib_name",
                  "IJoint",
                  "IEndEffectors",
                  "ISensors",
                  "misses_before_safe",
                  "deadline",
                  "safe_law",
                  "safe_damping",
                  "following_error",
                  "following_time",
                  "period_us",
                  "sched",
                  "prio",
                  "runtime",
                  "core_id",
                  "cpu_dma_latency_us",
                  "emergency_stops",
                  "params"},
                 warnings);
    hal.place = block->place();
    readType(*block, hal);
    readSafety(*block, hal);
    readScheduling(*block, hal);
    warnOfOldNames(*block, warnings);
    if (const auto params = block->find("params"); params && !params->entries().empty()) hal.params = params->node();
  }
  applyOverrides(overrides, hal);
  return hal;
}

}  // namespace robotui::rt::config
