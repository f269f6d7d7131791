#include <pthread.h>
#include <sched.h>

#include <cstring>

#include "robotui/rt/host/plugin_thread.h"
#include "robotui/rt/link/deadline.h"

namespace robotui::rt::host {
namespace {

constexpr std::size_t kStackBytes = 256 * 1024;

// Touches the stack once, so that no page of it is missing later.
__attribute__((noinline)) void touchStack() noexcept {
  std::array<char, kStackBytes> stack;
  for (std::size_t i = 0; i < kStackBytes; i += 4096) {
    static_cast<volatile char&>(stack[i]) = 0;
  }
}

}  // namespace

std::string scheduleThisThread(const ThreadPlan& plan) {
  touchStack();
  if (plan.priority == link::kByDeadline) {
    const link::Reservation reservation{plan.period_ns, plan.runtime};
    const int error = link::scheduleByDeadline(reservation);
    return error == 0 ? std::string() : link::deadlineRefusal(reservation, error);
  }
  if (const auto core = plan.core) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<std::size_t>(*core), &set);
    if (const int rc = pthread_setaffinity_np(pthread_self(), sizeof(set), &set); rc != 0) {
      return "core " + std::to_string(*core) + " cannot be used: " + std::strerror(rc) + ".";
    }
  }
  if (plan.priority > 0) {
    sched_param param{};
    param.sched_priority = plan.priority;
    if (const int rc = pthread_setschedparam(pthread_self(), SCHED_FIFO, &param); rc != 0) {
      return "priority " + std::to_string(plan.priority) + " of SCHED_FIFO is refused: " + std::strerror(rc) + ".";
    }
  }
  return {};
}

}  // namespace robotui::rt::host
