// Threads that the kernel gives so much time in each period (SCHED_DEADLINE), in place of a priority.
#pragma once

#include <cstdint>
#include <string>

namespace robotui::rt::link {

// Stands for that scheduler where a priority of SCHED_FIFO stands else: such threads go before all of those.
inline constexpr int kByDeadline = 100;

struct Reservation {
  std::int64_t period_ns;
  double runtime;  // share of the period that the thread may run, 0 to 1
};

// The calling thread. 0, or what errno says. The kernel refuses it where the processors have not that much time left,
// to threads that may not run on all processors, and to who lacks CAP_SYS_NICE, whatever its limit of rtprio is.
int scheduleByDeadline(const Reservation& reservation) noexcept;

// "SCHED_DEADLINE with 300 us in each 1000 us is refused: REASON.", with what helps against that error.
std::string deadlineRefusal(const Reservation& reservation, int error);

}  // namespace robotui::rt::link
