#include "robotui/rt/host/plugin_thread.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <stdexcept>

#include "robotui/rt/link/allocations.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/histogram.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::host {
namespace {

constexpr std::int64_t kPatience = 50 * link::kMillisecond;  // then it looks whether it is to end
constexpr std::uint64_t kFaultsEvery = 128;  // cycles between two looks at the page faults: a system call

std::int64_t pageFaults() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt + usage.ru_majflt;
}

}  // namespace

PluginThread::PluginThread(ThreadPlan plan, const link::StateSegment& state, const link::BoardSegment& board,
                           link::HostSegment& host)
    : plan_(std::move(plan)), state_(state), host_(host), reader_(state), board_(board),
      slot_(host, plan_.index, reader_.counts().joints) {
  auto& mine = statistics();
  link::assign(mine.name, plan_.name);
  mine.period_ns = plan_.period_ns;
  mine.priority = plan_.priority;
  mine.core = plan_.core.value_or(-1);
  mine.inside.store(link::kNobody, std::memory_order_relaxed);
}

PluginThread::~PluginThread() { stop(); }

void PluginThread::start() {
  std::promise<std::string> scheduled;
  auto outcome = scheduled.get_future();
  thread_ = std::thread([this, scheduled = std::move(scheduled)]() mutable {
    const std::string problem = scheduleThisThread(plan_);
    scheduled.set_value(problem);
    if (problem.empty()) {
      run();
    }
  });
  const std::string problem = outcome.get();
  if (!problem.empty()) {
    thread_.join();
    throw std::runtime_error("The thread " + plan_.name + " cannot run as configured: " + problem);
  }
}

void PluginThread::stop() {
  stopping_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) {
    thread_.join();
  }
}

void PluginThread::attach(HostedPlugin& plugin) noexcept { plugins_[plugin.index()].store(&plugin); }

// The thread marks itself inside before it looks at the places: who sees it outside afterwards is not seen by it any
// more.
void PluginThread::detach(HostedPlugin& plugin) noexcept {
  plugins_[plugin.index()].store(nullptr);
  while (inside_.load()) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
}

void PluginThread::run() noexcept {
  const std::int64_t patience = plan_.runs_alone ? std::min(plan_.period_ns, kPatience) : kPatience;
  while (!stopping_.load(std::memory_order_relaxed)) {
    const bool news = reader_.wait(link::now() + patience);
    if (news && !isDue()) {
      continue;
    }
    inside_.store(true);
    if (news || plan_.runs_alone) {
      step(news);
    } else {
      idle();
    }
    inside_.store(false);
  }
}

// Several cycles of the HAL may be one of this thread: it runs at multiples, or as soon after as it can.
bool PluginThread::isDue() noexcept {
  if (reader_.newest(frame_) != link::Read::kNew) {
    return false;
  }
  const std::int64_t hal = link::relaxedLoad(state_.loop.period_ns);
  every_ = hal <= 0 ? 1 : std::max<std::uint64_t>(1, static_cast<std::uint64_t>((plan_.period_ns + hal / 2) / hal));
  if (frame_.cycle < due_) {
    return false;
  }
  due_ = (frame_.cycle / every_ + 1) * every_;
  return true;
}

void PluginThread::step(bool news) noexcept {
  const link::CountAllocations counting;
  const std::int64_t begun = link::now();
  for (std::uint32_t i = 0; i < reader_.counts().joints; ++i) {
    commands_.joints[i].mode = 0;
  }
  bool commands = false;
  for (auto& place : plugins_) {
    HostedPlugin* plugin = place.load();
    if (plugin != nullptr && runPlugin(*plugin)) {
      collect(*plugin);
      commands = true;
    }
  }
  if (commands || commanded_) {
    commands_.cycle = frame_.cycle;
    commands_.written_ns = link::now();
    slot_.write(commands_);
  }
  commanded_ = commands;
  account(begun, news);
}

void PluginThread::idle() noexcept {
  for (auto& place : plugins_) {
    HostedPlugin* plugin = place.load();
    if (plugin != nullptr) {
      plugin->idle(time());
      host_.plugins[plugin->index()].state.store(static_cast<std::uint32_t>(plugin->shown()),
                                                 std::memory_order_relaxed);
    }
  }
}

bool PluginThread::runPlugin(HostedPlugin& plugin) noexcept {
  auto& mine = host_.plugins[plugin.index()];
  statistics().inside.store(plugin.index(), std::memory_order_relaxed);
  const std::int64_t begun = link::now();
  const bool ran = plugin.cycle(time(), static_cast<double>(plan_.period_ns) * 1e-9);
  const std::int64_t busy = link::now() - begun;
  statistics().inside.store(link::kNobody, std::memory_order_relaxed);
  mine.state.store(static_cast<std::uint32_t>(plugin.shown()), std::memory_order_relaxed);
  if (ran) {
    link::relaxedAdd<std::uint64_t>(mine.cycles, 1);
    link::relaxedStore(mine.last_busy_ns, busy);
    link::record(mine.busy, busy);
  }
  return ran;
}

// A joint has one owner: what others say about it is left out. The board is behind the HAL where a group is switched,
// and before it where one plugin is.
void PluginThread::collect(const HostedPlugin& plugin) noexcept {
  const auto outgoing = plugin.outgoing();
  const auto joints = std::min<std::size_t>(outgoing.size(), reader_.counts().joints);
  for (std::uint32_t i = 0; i < joints; ++i) {
    const bool owns = board_.owner(i) == plugin.index() || frame_.joints[i].owner == plugin.index();
    if (outgoing[i].mode != 0 && owns) {
      commands_.joints[i] = outgoing[i];
      commands_.joints[i].plugin = static_cast<std::uint16_t>(plugin.index());
    }
  }
}

void PluginThread::account(std::int64_t begun, bool news) noexcept {
  auto& mine = statistics();
  const std::int64_t busy = link::now() - begun;
  const std::uint64_t skipped =
      last_cycle_ == 0 || frame_.cycle <= last_cycle_ ? 0 : (frame_.cycle - last_cycle_ - 1) / every_;
  link::relaxedAdd<std::uint64_t>(mine.overruns, skipped > 0 ? skipped : (busy > plan_.period_ns ? 1 : 0));
  last_cycle_ = frame_.cycle;
  link::record(mine.busy, busy);
  if (news) {
    link::record(mine.wake_up, begun - frame_.sensed_ns);
  }
  link::relaxedStore(mine.allocations, link::allocationCount().calls);
  if (mine.cycles % kFaultsEvery == 0) {
    const std::int64_t faults = pageFaults();
    first_faults_ = first_faults_ < 0 ? faults : first_faults_;
    link::relaxedStore(mine.page_faults, static_cast<std::uint64_t>(faults - first_faults_));
  }
  link::relaxedAdd<std::uint64_t>(mine.cycles, 1);
}

}  // namespace robotui::rt::host
