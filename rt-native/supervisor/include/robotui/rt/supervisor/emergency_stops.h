// The emergency stops as the HAL says them last, in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/stop_bits.h"
#include "robotui/rt/supervisor/log_file.h"

namespace robotui::rt::supervisor {

class EmergencyStops {
 public:
  EmergencyStops(const config::HalConfig& hal, LogFile& log) : hal_(hal), stops_(hal.emergency_stops), log_(log) {}

  // What the HAL says; `words` are those behind the verb.
  void handle(std::string_view words);

  // The HAL is gone, and with it what it knew.
  void forget() noexcept { bits_ = {}; }

  // "The emergency stop 'pendant' is pressed", of as many as there are; empty where none is.
  std::string causeOf(const link::StopBits& bits) const;

  // Empty, or why nothing that leads joints may be started now.
  std::string objection() const;

  // Empty, or why a user cannot press or release that one; an empty name is all.
  std::string objectionToPress(std::string_view name) const;

  // A line each: state and name, with a tab between.
  std::string lines() const;

  std::size_t size() const noexcept { return stops_.size(); }
  const std::string& name(std::size_t stop) const { return stops_[stop].name; }

 private:
  std::string named(std::uint16_t bits) const;

  const config::HalConfig& hal_;
  const std::vector<config::EmergencyStop>& stops_;
  LogFile& log_;
  link::StopBits bits_{};
};

}  // namespace robotui::rt::supervisor
