// What a plugin that brings frames to poses says of its tasks, by a channel:
// docs/adr/0309-cartesian-plugins-say-their-tasks-by-a-channel.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/plugin/schema.h"

namespace robotui::rt {

enum class TaskPhase : std::uint32_t {
  kDisabled,
  kThere,   // at its target, or where it stays
  kMoving,  // to its target, or with a velocity
  kStuck    // it cannot go on
};

struct TaskReport {
  static constexpr Schema kSchema{"robotui/tasks", 1};
  static constexpr std::size_t kMostTasks = 12;      // of more the first are said
  using Text = std::array<char, link::kNameLength>;  // zero terminated
  using JointBits = std::array<std::uint64_t, link::kMaxJoints / 64>;

  struct Task {
    Text name;  // that commands have; empty where they have none
    Text link;
    Text base;       // the link whose frame its poses are in
    double linear;   // m/s, at most
    double angular;  // rad/s
    TaskPhase phase;
    std::uint32_t priority;  // from 1, which comes first
    std::uint32_t mask;      // bits of x, y, z, roll, pitch and yaw, x the lowest
    std::uint32_t unused;
  };

  JointBits joints;  // that it moves, by their index in the robot
  std::uint32_t count;
  std::uint32_t unused;
  std::array<Task, kMostTasks> tasks;
};

inline constexpr std::uint32_t kTaskDepth = 2;

inline std::string taskChannel(std::string_view plugin) { return "tasks/" + std::string(plugin); }

// What does not fit is cut.
inline void assign(TaskReport::Text& into, std::string_view text) noexcept {
  const std::size_t part = std::min(text.size(), into.size() - 1);
  std::copy_n(text.data(), part, into.data());
  into[part] = 0;
}

// Up to the first zero byte, or all of it where another process left none.
inline std::string_view view(const TaskReport::Text& text) noexcept {
  return {text.data(), static_cast<std::size_t>(std::find(text.begin(), text.end(), 0) - text.begin())};
}

inline void addJoint(TaskReport& report, int index) noexcept {
  const auto bit = static_cast<std::size_t>(index);
  if (bit < link::kMaxJoints) report.joints[bit / 64] |= std::uint64_t{1} << (bit % 64);
}

inline bool hasJoint(const TaskReport& report, std::uint32_t index) noexcept {
  return index < link::kMaxJoints && (report.joints[index / 64] >> (index % 64) & 1U) != 0;
}

}  // namespace robotui::rt
