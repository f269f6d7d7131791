// Bells: numbers in shared memory that rise, on which any process sleeps that has mapped them, also read-only.
#pragma once

#include <atomic>
#include <cstdint>

namespace robotui::rt::link {

// Sleeps until `bell` is no longer `seen`, or until `deadline_ns` of CLOCK_MONOTONIC. True where it was not the
// deadline that ended the sleep: it may have been a signal, so look at what you wait for again.
bool waitForBell(const std::atomic<std::uint32_t>& bell, std::uint32_t seen, std::int64_t deadline_ns) noexcept;

// Raises the bell and wakes all who sleep on it.
void ringBell(std::atomic<std::uint32_t>& bell) noexcept;

}  // namespace robotui::rt::link
