// Which emergency stops keep the robot safe: a bit for each, in the order of the configuration.
#pragma once

#include <cstdint>

namespace robotui::rt::link {

inline constexpr std::uint32_t kMaxStops = 16;

struct StopBits {
  std::uint16_t pressed = 0;
  std::uint16_t unread = 0;  // nothing is known of them, which counts as pressed
  bool any() const noexcept { return (pressed | unread) != 0; }
  friend bool operator==(const StopBits&, const StopBits&) = default;
};

}  // namespace robotui::rt::link
