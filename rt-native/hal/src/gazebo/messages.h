// Messages of the simulator, read from bytes of another process: what is too long, no such message, or no number is
// refused.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "sample.h"

namespace robotui::rt::hal::gazebo {

inline constexpr std::string_view kModel = "Model";
inline constexpr std::string_view kImu = "IMU";
inline constexpr std::string_view kWrench = "Wrench";
inline constexpr std::string_view kStatistics = "WorldStatistics";

// Whether the full name of a type, such as ignition.msgs.Model, is that of this message. Newer simulators write
// gz.msgs.
bool isType(std::string_view full_name, std::string_view message) noexcept;

using Bytes = std::span<const std::byte>;
using JointIndex = std::unordered_map<std::string, std::size_t>;  // of the robot, by name

enum class Reading : std::uint8_t { kSound, kUnreadable, kLacksJoint, kNoNumber };

struct JointsReading {
  Reading how;
  std::size_t joint;  // which one lacks, or is no number
};

// The stamp and the joints; what else the model has is left out. Nothing in `into` is worth anything where it is not
// kSound.
JointsReading readJoints(Bytes message, const JointIndex& index, Sample& into);

// For a sentence: at most that many.
std::vector<std::string> jointNames(Bytes message, std::size_t most);

std::optional<link::ImuState> readImu(Bytes message);
std::optional<link::ForceTorqueState> readWrench(Bytes message);

struct WorldState {
  std::int64_t time_ns;  // simulated
  bool paused;
  double real_time_factor;  // how fast simulated time goes; 1 is as fast as a clock
};

std::optional<WorldState> readStatistics(Bytes message);

}  // namespace robotui::rt::hal::gazebo
