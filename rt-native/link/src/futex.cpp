#include "robotui/rt/link/futex.h"

#include <cerrno>
#include <climits>

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::link {

// Not FUTEX_PRIVATE: the bell is shared by processes. The bitset form is the one with an absolute deadline.
bool waitForBell(const std::atomic<std::uint32_t>& bell, std::uint32_t seen, std::int64_t deadline_ns) noexcept {
  if (bell.load(std::memory_order_acquire) != seen) return true;
  const timespec deadline = toTimespec(deadline_ns < 0 ? 0 : deadline_ns);
  const long result = ::syscall(SYS_futex, &bell, FUTEX_WAIT_BITSET, seen, &deadline, nullptr, FUTEX_BITSET_MATCH_ANY);
  return result == 0 || errno != ETIMEDOUT;
}

void ringBell(std::atomic<std::uint32_t>& bell) noexcept {
  bell.fetch_add(1, std::memory_order_release);
  ::syscall(SYS_futex, &bell, FUTEX_WAKE_BITSET, INT_MAX, nullptr, nullptr, FUTEX_BITSET_MATCH_ANY);
}

}  // namespace robotui::rt::link
