// The one clock of control: CLOCK_MONOTONIC in nanoseconds.
#pragma once

#include <cstdint>
#include <ctime>

namespace robotui::rt::link {

inline constexpr std::int64_t kSecond = 1'000'000'000;
inline constexpr std::int64_t kMillisecond = 1'000'000;
inline constexpr std::int64_t kMicrosecond = 1'000;

inline std::int64_t toNs(const timespec& time) noexcept { return std::int64_t{time.tv_sec} * kSecond + time.tv_nsec; }

inline timespec toTimespec(std::int64_t ns) noexcept {
  return {static_cast<std::time_t>(ns / kSecond), static_cast<long>(ns % kSecond)};
}

inline std::int64_t now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return toNs(time);
}

}  // namespace robotui::rt::link
