// What HALInterface.params says of a bus of drives.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "objects.h"
#include "pdo_layout.h"
#include "robotui/rt/config/config.h"

namespace robotui::rt::hal::canopen {

// An object that the user writes at the start.
struct GivenObject {
  Object object;
  std::uint8_t size;
  std::uint32_t value;
};

struct DriveSettings {
  std::string joint;
  std::uint8_t node = 0;
  double counts = 0;          // per rad or m; negative where the drive turns the other way
  double offset = 0;          // rad or m of the joint where the drive counts 0
  double velocity_scale = 0;  // of 0x60FF and 0x606C per rad/s or m/s
  double rated_effort = 0;    // N m or N at the joint of 1000 in 0x6071 and 0x6077; 0 where it is not known
  double most_effort = 0;     // N m or N
  double lower = 0;           // rad or m; infinite where there is none
  double upper = 0;
  std::vector<GivenObject> objects;
  bool has_stop = false;  // an emergency stop is wired to its digital inputs
};

// An emergency stop at the digital inputs of a drive.
struct StopSettings {
  std::size_t drive = 0;
  int input = 0;
  bool closed = true;  // what the input says while it is released
};

struct Settings {
  std::string interface;
  std::int64_t bitrate = 0;
  std::int64_t period_ns = 0;
  std::int64_t heartbeat_ns = 0;          // of the drives, and of the control
  std::int64_t heartbeat_timeout_ns = 0;  // of both
  std::int64_t enable_timeout_ns = 0;
  int sdo_timeout_ms = 0;
  std::uint32_t missed_pdos = 0;  // in turn
  std::uint8_t own_node = 0;
  bool writes_mapping = true;
  bool enables = true;  // else drives are looked at alone
  Ways ways;
  std::vector<DriveSettings> drives;  // in the order of the joints
  std::vector<StopSettings> stops;    // in the order of the configuration
  Ways waysOf(const DriveSettings& drive) const noexcept;
};

// Throws config::ConfigError.
Settings readSettings(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns);

// How much of a period the frames of a cycle take, SYNC included: with the most bits that stuffing may add.
double loadOf(const Settings& settings, std::size_t frames) noexcept;

}  // namespace robotui::rt::hal::canopen
