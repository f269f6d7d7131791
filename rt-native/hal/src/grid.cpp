#include "grid.h"

#include <cerrno>
#include <ctime>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal {

Grid::Grid(std::int64_t period_ns) noexcept : period_ns_(period_ns), point_ns_(link::now()) {}

std::int64_t Grid::next() noexcept {
  point_ns_ += period_ns_;
  if (const std::int64_t late = link::now() - point_ns_; late > 0) {
    const std::int64_t points = (late + period_ns_ - 1) / period_ns_;
    skipped_ += static_cast<std::uint64_t>(points);
    point_ns_ += points * period_ns_;
  }
  const timespec at = link::toTimespec(point_ns_);
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR) {
  }
  return point_ns_;
}

}  // namespace robotui::rt::hal
