#include "world_inbox.h"

#include <cstdio>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr double kSlow = 0.8;     // of real time
constexpr int kSlowForLong = 10;  // statistics, of which a simulator sends five a second

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", value);
  return text;
}

}  // namespace

void WorldInbox::hear(std::string_view type, Bytes message) {
  const auto state = isType(type, kStatistics) ? readStatistics(message) : std::nullopt;
  if (!state) return;
  const std::int64_t now = link::now();
  paused_ns_.store(state->paused ? now : 0, std::memory_order_release);
  if (state->paused) {
    notices_->raise("pause",
                    "The world '" + world_ + "' is paused at " +
                        number(static_cast<double>(state->time_ns) / link::kSecond) +
                        " s of simulated time: the joints are safe until it runs and plugins are started again.",
                    now);
    return;
  }
  notices_->clear("pause", "The world '" + world_ + "' runs.");
  speed(*state, now);
}

void WorldInbox::speed(const WorldState& state, std::int64_t now_ns) {
  if (!(state.real_time_factor < kSlow)) {
    slow_ = 0;
    notices_->clear("slow", "The world '" + world_ + "' is nearly as fast as real time again.");
    return;
  }
  if (++slow_ < kSlowForLong) return;
  notices_->raise("slow",
                  "The world '" + world_ + "' runs at " + number(state.real_time_factor) +
                      " of real time: joints lag behind what plugins ask for. A simpler world, longer steps or no "
                      "window help.",
                  now_ns);
}

}  // namespace robotui::rt::hal::gazebo
