// Memory that stays in memory: a page that has to be fetched would cost a cycle.
#pragma once

namespace robotui::rt::link {

// Locks what the process has, and what it will have. False where that is not allowed, or only up to a limit (then errno
// says which): nothing is locked then, since at the limit memory could not even be shared any more.
bool lockMemory() noexcept;

}  // namespace robotui::rt::link
