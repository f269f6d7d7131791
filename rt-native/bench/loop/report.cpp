#include "report.h"

#include "robotui/rt/link/histogram.h"

namespace robotui::rt::bench {
namespace {

template <class Numbers>
std::string list(const Numbers& numbers) {
  std::string text = "[";
  for (const auto number : numbers) text += (text.size() > 1 ? "," : "") + std::to_string(number);
  return text + "]";
}

template <class Number>
std::string member(const char* name, Number value) {
  return '"' + std::string(name) + "\": " + std::to_string(value) + ", ";
}

}  // namespace

std::string json(const link::Histogram& late, const link::Histogram& early) {
  return list(link::difference(late, early).buckets);
}

std::string json(std::span<const std::int64_t> numbers) { return list(numbers); }

std::string members(const link::LoopStatistics& late, const link::LoopStatistics& early) {
  return member("priority", late.priority) + member("core", late.core) + member("cycles", late.cycles - early.cycles) +
         member("overruns", late.overruns - early.overruns) +
         member("missed", late.missed_commands - early.missed_commands) +
         "\"wake_up\": " + json(late.wake_up, early.wake_up) + ", \"busy\": " + json(late.busy, early.busy);
}

}  // namespace robotui::rt::bench
