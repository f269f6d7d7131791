// What a process and a thread need to keep time.
#pragma once

#include <optional>
#include <string>

#include "robotui/rt/link/deadline.h"

namespace robotui::rt::hal {

// Each gives a sentence with the remedy where the system refuses.
using Refusal = std::optional<std::string>;

// All memory of the process stays where it is, now and later; freed memory is kept, so that no page is asked for again.
Refusal lockMemory();

// Of the calling thread: SCHED_FIFO or SCHED_DEADLINE, one CPU, no slack of its timers, its stack touched.
Refusal scheduleFifo(int priority);
Refusal scheduleDeadline(const link::Reservation& reservation);
Refusal pinTo(int core);
void prepareThread() noexcept;

// Page faults of the calling thread so far, minor and major.
long pageFaults() noexcept;

}  // namespace robotui::rt::hal
