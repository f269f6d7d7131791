#include "loop.h"

#include <future>
#include <stdexcept>

#include "grid.h"
#include "real_time.h"
#include "robotui/rt/link/allocations.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/histogram.h"

namespace robotui::rt::hal {

namespace {

constexpr std::uint64_t kFaultsEvery = 64;  // cycles between two looks at the page faults: a system call
constexpr std::int64_t kLongestStop = link::kSecond;

}  // namespace

std::vector<std::string> Loop::prepare() const {
  std::vector<std::string> refusals;
  const auto note = [&](Refusal refusal) {
    if (refusal) refusals.push_back(std::move(*refusal));
  };
  if (settings_.core) note(pinTo(*settings_.core));
  cycle_->statistics().core = settings_.core.value_or(-1);
  if (settings_.priority > 0) {
    note(lockMemory());
    Refusal refusal = settings_.priority == link::kByDeadline
                          ? scheduleDeadline({settings_.period_ns, settings_.runtime})
                          : scheduleFifo(settings_.priority);
    cycle_->statistics().priority = refusal ? 0 : settings_.priority;
    note(std::move(refusal));
  }
  prepareThread();
  return refusals;
}

std::vector<std::string> Loop::start() {
  std::promise<std::vector<std::string>> prepared;
  std::future<std::vector<std::string>> result = prepared.get_future();
  thread_ = std::thread([this, prepared = std::move(prepared)]() mutable {
    std::vector<std::string> refusals = prepare();
    const bool go = refusals.empty() || settings_.allow_non_rt;
    prepared.set_value(std::move(refusals));
    if (go) cycle();
  });
  std::vector<std::string> refusals = result.get();
  if (refusals.empty() || settings_.allow_non_rt) return refusals;
  thread_.join();
  throw std::runtime_error(refusals.front());
}

void Loop::stop() noexcept {
  if (!thread_.joinable()) return;
  cycle_->end();
  stopping_.store(true);
  thread_.join();
}

// At least two cycles: one that senses the end, one that sends it.
bool Loop::isDone(std::uint64_t number) noexcept {
  if (!stopping_.load(std::memory_order_relaxed)) return false;
  if (stop_cycle_ == 0) stop_cycle_ = number;
  const std::uint64_t since = number - stop_cycle_;
  return since >= 2 && (cycle_->isAtRest() || static_cast<std::int64_t>(since) * settings_.period_ns > kLongestStop);
}

void Loop::once(std::uint64_t number, std::int64_t point_ns) noexcept {
  link::LoopStatistics& statistics = cycle_->statistics();
  const std::int64_t start = link::now();
  link::record(statistics.wake_up, start - point_ns);
  if (last_start_ns_ != 0) link::record(statistics.period, start - last_start_ns_);
  last_start_ns_ = start;
  {
    const link::CountAllocations count;
    cycle_->run(number, point_ns);
  }
  link::record(statistics.busy, link::now() - start);
  link::relaxedStore(statistics.allocations, link::allocationCount().calls);
  link::relaxedStore(statistics.cycles, number);
}

// Page faults count after the first cycle, which touches what is touched once.
void Loop::cycle() noexcept {
  link::LoopStatistics& statistics = cycle_->statistics();
  Grid grid(settings_.period_ns);
  long faults_before = 0;
  for (std::uint64_t number = 1; !isDone(number); ++number) {
    once(number, grid.next());
    link::relaxedStore(statistics.overruns, grid.skipped());
    if (number == 1) faults_before = pageFaults();
    if (number % kFaultsEvery == 0)
      link::relaxedStore(statistics.page_faults, static_cast<std::uint64_t>(pageFaults() - faults_before));
  }
}

}  // namespace robotui::rt::hal
