// Whether this process may run in real time.
#pragma once

#include <string>

#include "robotui/rt/link/deadline.h"

namespace robotui::rt::supervisor {

// Empty, or the reason and the remedy: `priority` of SCHED_FIFO, or where that is link::kByDeadline the reservation,
// and locked memory are tried.
std::string lackOfRights(int priority, const link::Reservation& reservation);

}  // namespace robotui::rt::supervisor
