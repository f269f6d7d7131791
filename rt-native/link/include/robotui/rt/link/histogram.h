// How durations are counted: see Histogram in layout.h for the buckets.
#pragma once

#include <algorithm>
#include <bit>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::link {

constexpr std::int64_t bucketLower(std::size_t i) noexcept {
  return static_cast<std::int64_t>(4 + i % 4) << (4 + i / 4);
}

constexpr std::size_t bucketOf(std::int64_t ns) noexcept {
  if (ns < bucketLower(1)) return 0;
  const auto value = static_cast<std::uint64_t>(ns);
  const auto octave = static_cast<std::size_t>(std::bit_width(value)) - 1;  // at least 6
  return std::min<std::size_t>((octave - 6) * 4 + ((value >> (octave - 2)) & 3), kBuckets - 1);
}

// One writer. A negative duration (a clock that two CPUs read) counts as none.
inline void record(Histogram& into, std::int64_t ns) noexcept {
  relaxedAdd<std::uint32_t>(into.buckets[bucketOf(ns)], 1);
  if (ns > relaxedLoad(into.max_ns)) relaxedStore(into.max_ns, ns);
  relaxedAdd<std::uint64_t>(into.count, 1);
}

// The end of the bucket in which the value at `fraction` (0..1) of all counted ones lies, but never more than the
// greatest; 0 where nothing was counted. At most a quarter above the true value from 64 ns on. Of a local copy
// (relaxedCopy).
std::int64_t percentile(const Histogram& of, double fraction) noexcept;

// What was counted in between two copies of one histogram. Its greatest value is that of `late`: it may be older.
Histogram difference(const Histogram& late, const Histogram& early) noexcept;

}  // namespace robotui::rt::link
