// Points of time with one distance from the first: a late cycle does not shift those that follow.
#pragma once

#include <cstdint>

namespace robotui::rt::hal {

class Grid {
 public:
  // The first point is one period from now.
  explicit Grid(std::int64_t period_ns) noexcept;

  // Sleeps until the next point that is not past, and says when that was to be. Points that passed before are skipped
  // and counted.
  std::int64_t next() noexcept;

  std::uint64_t skipped() const noexcept { return skipped_; }

 private:
  std::int64_t period_ns_;
  std::int64_t point_ns_;
  std::uint64_t skipped_ = 0;
};

}  // namespace robotui::rt::hal
