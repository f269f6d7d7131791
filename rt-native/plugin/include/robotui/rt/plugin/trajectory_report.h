// What the plugin JointTrajectory says in every cycle, by a channel, to whoever has told it a trajectory:
// docs/adr/0226-follow-joint-trajectory-is-served-by-the-ros-process.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "robotui/rt/plugin/schema.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt {

enum class TrajectoryPhase : std::uint32_t {
  kNone,
  kTelling,
  kChecking,
  kRefused,    // before it began; what ran before goes on
  kBadJoints,  // likewise: it names others than it should
  kMoving,
  kSettling,  // at its end, joints come within their tolerances
  kDone,
  kStopped,  // somebody wanted that, or the plugin was stopped
  kOffPath,  // a joint left its path tolerance
  kOffGoal   // a joint did not come within its goal tolerance in time
};

// A trajectory that was told after another one is followed once it was found good: until then there are two of them.
struct TrajectoryReport {
  static constexpr Schema kSchema{"robotui/trajectory", 1};
  using Text = std::array<char, 256>;  // zero terminated

  std::uint64_t told;      // the tag of that which was told last; 0 is none
  std::uint64_t followed;  // and of that which is followed, or was last
  TrajectoryPhase told_phase;
  TrajectoryPhase phase;  // of what is followed, from kMoving on
  double seconds;         // on its way
  Text refusal;           // why what was told last was refused
  Text ending;            // why what was followed was given up
  // Where joints are to be, by their index in the robot; those that the plugin does not command are zero.
  std::array<double, link::kMaxJoints> positions;  // rad or m
  std::array<double, link::kMaxJoints> velocities;
  std::array<double, link::kMaxJoints> accelerations;
};

inline constexpr std::uint32_t kTrajectoryDepth = 2;

inline std::string trajectoryChannel(std::string_view plugin) { return "trajectory/" + std::string(plugin); }

// What does not fit is cut.
inline void assign(TrajectoryReport::Text& into, std::string_view text) noexcept {
  const std::size_t part = std::min(text.size(), into.size() - 1);
  std::copy_n(text.data(), part, into.data());
  into[part] = 0;
}

// Up to the first zero byte, or all of it where another process left none.
inline std::string_view view(const TrajectoryReport::Text& text) noexcept {
  return {text.data(), static_cast<std::size_t>(std::find(text.begin(), text.end(), 0) - text.begin())};
}

}  // namespace robotui::rt
