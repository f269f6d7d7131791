#include "robotui/rt/link/host_damage.h"

#include <algorithm>
#include <atomic>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/deadline.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/link/segment.h"

// Thread sanitizer does not model fences. It need not here: all accesses around them are atomic.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wtsan"
#endif

namespace robotui::rt::link {

namespace {

constexpr std::int64_t kLongest = 24 * 3600 * kSecond;  // of anything that is measured
constexpr std::int64_t kLongestPeriod = 1000 * kSecond;
constexpr std::int32_t kMostCores = 8192;

template <class T>
bool isWithin(const T& shared, T least, T most) {
  const T value = relaxedLoad(shared);
  return value >= least && value <= most;
}

bool isName(const Name& shared) {
  Name name;
  relaxedCopyOut(name.data(), shared.data(), sizeof(name));
  const auto end = std::find(name.begin(), name.end(), '\0');
  return end != name.end() &&
         std::none_of(name.begin(), end, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; });
}

// The buckets are counted before their sum. It wraps with the buckets, which are shorter: then it says nothing.
bool isHistogram(const Histogram& shared) {
  const std::uint64_t before = relaxedLoad(shared.count);
  std::atomic_thread_fence(std::memory_order_acquire);
  std::uint64_t sum = 0;
  for (const std::uint32_t& bucket : shared.buckets) sum += relaxedLoad(bucket);
  std::atomic_thread_fence(std::memory_order_acquire);
  const std::uint64_t after = relaxedLoad(shared.count);
  const bool is_sum = after > UINT32_MAX || (sum >= before && sum <= after + 1);
  return is_sum && isWithin<std::int64_t>(shared.max_ns, 0, kLongest);
}

bool isThread(const ThreadStatistics& thread) {
  const std::uint32_t inside = thread.inside.load(std::memory_order_relaxed);
  return isName(thread.name) && isWithin<std::int64_t>(thread.period_ns, 0, kLongestPeriod) &&
         isWithin<std::int32_t>(thread.priority, 0, kByDeadline) &&
         isWithin<std::int32_t>(thread.core, -1, kMostCores) && (inside == kNobody || inside < kMaxPlugins) &&
         isHistogram(thread.wake_up) && isHistogram(thread.busy);
}

bool isPlugin(const PluginStatistics& plugin) {
  return plugin.state.load(std::memory_order_relaxed) <= static_cast<std::uint32_t>(PluginState::kFailed) &&
         isWithin<std::uint32_t>(plugin.thread, 0, kMaxThreads - 1) &&
         isWithin<std::int64_t>(plugin.last_busy_ns, 0, kLongest) && isHistogram(plugin.busy);
}

}  // namespace

std::string damageOf(const HostSegment& host) {
  if (!faultOf(relaxedCopy(host.header), SegmentKind::kHost, sizeof(host)).empty()) return "its head is overwritten";
  if (relaxedLoad(host.threads) > kMaxThreads) return "the number of its threads is overwritten";
  if (!std::all_of(host.thread_statistics.begin(), host.thread_statistics.end(), isThread))
    return "what it says of its threads is overwritten";
  if (!std::all_of(host.plugins.begin(), host.plugins.end(), isPlugin))
    return "what it says of its plugins is overwritten";
  return {};
}

}  // namespace robotui::rt::link
