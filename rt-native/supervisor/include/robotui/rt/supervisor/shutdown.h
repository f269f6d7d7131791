// The end of processes: asked first, and killed when they take too long or the user asks a second time.
#pragma once

#include <cstdint>
#include <vector>

#include "robotui/rt/supervisor/child.h"
#include "robotui/rt/supervisor/signals.h"

namespace robotui::rt::supervisor {

// Sends each of them `end` and waits until all are gone.
void endProcesses(const std::vector<Child*>& children, std::int64_t patience_ns, Signals& signals);

}  // namespace robotui::rt::supervisor
