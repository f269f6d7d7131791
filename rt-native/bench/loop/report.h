// How the programs of this folder tell what was counted: as JSON.
#pragma once

#include <span>
#include <string>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::bench {

// The counts of all buckets between two copies of one histogram.
std::string json(const link::Histogram& late, const link::Histogram& early);

std::string json(std::span<const std::int64_t> numbers);

// The members of an object, without its braces: what a loop did between two copies of its statistics.
std::string members(const link::LoopStatistics& late, const link::LoopStatistics& early);

}  // namespace robotui::rt::bench
