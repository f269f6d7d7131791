#include "robotui/rt/link/deadline.h"

#include <linux/sched.h>
#include <linux/sched/types.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

namespace robotui::rt::link {
namespace {

std::uint64_t runtimeOf(const Reservation& reservation) noexcept {
  return static_cast<std::uint64_t>(std::llround(static_cast<double>(reservation.period_ns) * reservation.runtime));
}

const char* remedyFor(int error) noexcept {
  switch (error) {
    case EPERM:
      return " It needs CAP_SYS_NICE (a limit of rtprio is not enough; in a unit of systemd AmbientCapabilities="
             "CAP_SYS_NICE), and may not be kept on some of the processors (taskset, a cpuset).";
    case EBUSY:
      return " So much time is not left for it beside other such threads: write smaller runtimes or longer periods.";
    default: return " This kernel does not take it.";
  }
}

}  // namespace

// glibc has no function for it.
int scheduleByDeadline(const Reservation& reservation) noexcept {
  sched_attr attributes{};
  attributes.size = sizeof(attributes);
  attributes.sched_policy = SCHED_DEADLINE;
  attributes.sched_runtime = runtimeOf(reservation);
  attributes.sched_deadline = attributes.sched_period = static_cast<std::uint64_t>(reservation.period_ns);
  return ::syscall(SYS_sched_setattr, 0, &attributes, 0) == 0 ? 0 : errno;
}

std::string deadlineRefusal(const Reservation& reservation, int error) {
  return "SCHED_DEADLINE with " + std::to_string(runtimeOf(reservation) / 1000) + " us in each " +
         std::to_string(reservation.period_ns / 1000) + " us is refused: " + std::strerror(error) + "." +
         remedyFor(error) + " Or write sched: fifo.";
}

}  // namespace robotui::rt::link
