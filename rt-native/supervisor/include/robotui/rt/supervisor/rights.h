// Whether this process may run in real time.
#pragma once

#include <string>

namespace robotui::rt::supervisor {

// Empty, or the reason and the remedy: `priority` of SCHED_FIFO and locked memory are tried.
std::string lackOfRights(int priority);

}  // namespace robotui::rt::supervisor
