#include "robotui/rt/link/histogram.h"

#include <cmath>

namespace robotui::rt::link {

namespace {

std::uint64_t total(const Histogram& of) noexcept {
  std::uint64_t sum = 0;
  for (const std::uint32_t bucket : of.buckets) sum += bucket;
  return sum;
}

}  // namespace

// The buckets' own sum counts, not `count`: a reader may have copied the two at different moments.
std::int64_t percentile(const Histogram& of, double fraction) noexcept {
  const std::uint64_t all = total(of);
  if (all == 0) return 0;
  const double share = std::ceil(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(all));
  const auto rank = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(share));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i + 1 < kBuckets; ++i) {
    seen += of.buckets[i];
    if (seen >= rank) return std::min(bucketLower(i + 1), of.max_ns);
  }
  return of.max_ns;
}

Histogram difference(const Histogram& late, const Histogram& early) noexcept {
  Histogram result = late;
  result.count -= early.count;
  for (std::size_t i = 0; i < kBuckets; ++i) result.buckets[i] -= early.buckets[i];
  return result;
}

}  // namespace robotui::rt::link
