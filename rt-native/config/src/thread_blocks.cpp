#include "blocks.h"

#include <sched.h>

#include <cmath>

#include "robotui/rt/link/deadline.h"

namespace robotui::rt::config {
namespace {

constexpr double kMicro = 1e6;
constexpr double kLeastRuntime = 0.05;
constexpr double kMostRuntime = 0.9;
constexpr const char* kDefaultName = "rt_main";
constexpr const char* kDefaultHost = "rt";

// Seconds, as XBot writes it. A number that can only be microseconds is told so.
std::chrono::microseconds readPeriod(const Reader& block, std::chrono::microseconds otherwise) {
  const auto period = block.find("period");
  if (!period) return otherwise;
  const double seconds = period->real(0, 1e9);
  if (seconds > 10) period->fail("is in seconds; write 0.001 for a millisecond");
  if (seconds < 1e-4) period->fail("is shorter than 0.0001 s");
  return std::chrono::microseconds(std::llround(seconds * kMicro));
}

// With --period all threads that went with the HAL go on with it.
std::chrono::microseconds follow(std::chrono::microseconds period, const HalConfig& hal,
                                 std::chrono::microseconds written) {
  return period == written ? hal.period : period;
}

void mustBeMultiple(const ThreadConfig& thread, const HalConfig& hal) {
  if (thread.period % hal.period == std::chrono::microseconds(0)) return;
  throw ConfigError(thread.place,
                    "the thread '" + thread.name + "' has a period of " + std::to_string(thread.period.count()) +
                        " us, which is no multiple of the HAL's, " + std::to_string(hal.period.count()) + " us");
}

ThreadConfig readThread(const std::string& name, const Reader& block, std::chrono::microseconds written,
                        std::vector<std::string>& warnings) {
  block.knows({"sched", "prio", "period", "core_id", "host", "runtime"}, warnings);
  ThreadConfig thread;
  thread.name = name;
  thread.place = block.place();
  thread.host = block.textOr("host", kDefaultHost);
  if (const auto sched = block.find("sched")) {
    const std::string name_of_it = sched->oneOf({"fifo", "other", "deadline"});
    thread.scheduling = name_of_it == "fifo"    ? Scheduling::kFifo
                        : name_of_it == "other" ? Scheduling::kOther
                                                : Scheduling::kDeadline;
  }
  thread.period = readPeriod(block, written);
  if (thread.scheduling == Scheduling::kDeadline) {
    thread.priority = link::kByDeadline;
    thread.runtime = readRuntime(block, thread.runtime);
    return thread;
  }
  const bool fifo = thread.scheduling == Scheduling::kFifo;
  thread.priority = static_cast<int>(block.wholeOr("prio", fifo ? 60 : 0, fifo ? 1 : 0, fifo ? 98 : 0));
  thread.core = readCore(block);
  return thread;
}

std::string allowedCores(const cpu_set_t& set) {
  std::string text;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &set)) text += (text.empty() ? "" : ", ") + std::to_string(core);
  }
  return text;
}

}  // namespace

double readRuntime(const Reader& block, double usual) {
  if (const auto prio = block.find("prio")) prio->fail("means nothing with sched: deadline; leave it out");
  if (const auto core = block.find("core_id"))
    core->fail("cannot be with sched: deadline: the kernel refuses that to threads which are kept on one CPU");
  return block.realOr("runtime", usual, kLeastRuntime, kMostRuntime);
}

std::optional<int> readCore(const Reader& block) {
  const auto value = block.find("core_id");
  if (!value) return {};
  const int core = static_cast<int>(value->whole(0, CPU_SETSIZE - 1));
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) == 0 && !CPU_ISSET(core, &set)) {
    value->fail("is " + std::to_string(core) + ", on which this process may not run; there are " + allowedCores(set));
  }
  return core;
}

std::vector<ThreadConfig> readThreads(const Reader& top, const HalConfig& hal, const Overrides& overrides,
                                      std::vector<std::string>& warnings) {
  const HalConfig written = overrides.period ? readHal(top, Overrides{}, warnings) : hal;
  std::vector<ThreadConfig> threads;
  if (const auto block = top.find("xbotcore_threads")) {
    for (const auto& [name, value] : block->entries()) {
      threads.push_back(readThread(name, value, written.period, warnings));
      threads.back().period = follow(threads.back().period, hal, written.period);
      mustBeMultiple(threads.back(), hal);
    }
  }
  if (threads.empty()) {
    ThreadConfig thread;
    thread.name = kDefaultName;
    thread.host = kDefaultHost;
    thread.period = hal.period;
    thread.place = top.place();
    threads.push_back(thread);
  }
  return threads;
}

}  // namespace robotui::rt::config
