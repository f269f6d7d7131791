// The configuration of a robot and its control, as XBot users write it: docs/rt-configuration.md names every key.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace robotui::rt::config {

struct Place {
  std::filesystem::path file;
  int line = 0;  // from 1; 0 is the whole file
  int column = 0;
};

// A mistake of the user: names the place, what was expected, and what to write.
class ConfigError : public std::runtime_error {
 public:
  ConfigError(const Place& place, const std::string& what);
};

enum class JointType : std::uint8_t {
  kRevolute,
  kPrismatic
};  // continuous joints are revolute without position limits

// One joint that can be commanded, in the order of the ids of the joint map.
struct JointDescription {
  int id;
  std::string name;
  JointType type;
  double lower;  // rad or m; infinite where the URDF has none
  double upper;
  double velocity;  // rad/s or m/s
  double effort;    // N m or N
  // Of what the joint is told, rad/s^2 and rad/s^3 or m/s^2 and m/s^3; infinite where neither URDF nor configuration
  // has one.
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
};

// A group of the SRDF that is one chain of commanded joints, from base to tip.
struct ChainDescription {
  std::string name;
  std::string base_link;
  std::string tip_link;
  std::vector<std::string> joints;
};

struct SensorDescription {
  std::string name;  // of its link (IMU) or joint (force-torque)
  std::string link;
};

// A named posture of the SRDF (group_state), such as "home".
struct Posture {
  std::string name;
  std::string group;
  std::vector<std::pair<std::string, double>> joints;
};

// What URDF, SRDF and joint map say together. The URDF itself stays text: models parse it again as they need.
struct RobotDescription {
  std::string name;
  std::string urdf;
  std::string srdf;
  bool floating_base;
  std::vector<JointDescription> joints;
  std::vector<ChainDescription> chains;
  std::vector<SensorDescription> imus;
  std::vector<SensorDescription> force_torques;
  std::vector<Posture> postures;
  std::vector<std::pair<std::string, std::string>> free_to_touch;  // links, by the SRDF's disable_collisions
};

// Reads and checks the three files: every joint of the map is in the URDF, ids and names are unique, limits are
// numbers. An empty `srdf` is none: no chains, sensors and postures.
RobotDescription describe(const std::filesystem::path& urdf, const std::filesystem::path& srdf,
                          const std::filesystem::path& joint_map, bool floating_base);

enum class SafeLaw : std::uint8_t { kDamping, kGravity };  // what joints in effort mode do when their plugin fails

// An emergency stop, and the input that it is wired to.
struct EmergencyStop {
  std::string name;
  std::string joint;   // whose drive has the input; empty where the HAL has inputs of its own
  int input = 0;       // a bit, from 0
  bool closed = true;  // what the input says while the stop is released: a closed circuit, or an open one
  Place place;
};

// NOLINTNEXTLINE(bugprone-exception-escape): a YAML::Node can only be copied, which throws of one that is not there
struct HalConfig {
  std::string type = "dummy";  // dummy, mujoco, gazebo, udp, canopen, ethercat or library
  std::filesystem::path lib_file;
  std::string lib_name;
  int misses_before_safe = 2;
  double deadline = 0.8;  // fraction of the period until which commands are awaited
  SafeLaw safe_law = SafeLaw::kGravity;
  double safe_damping = 5.0;  // N m s/rad or N s/m
  // By joint, rad or m: what it may be away from its position reference for following_time (s) before it is made safe.
  std::vector<double> following_errors;  // infinity where it is not supervised
  double following_time = 0.5;
  std::vector<EmergencyStop> emergency_stops;
  std::chrono::microseconds period{1000};
  std::optional<int> core;
  int priority = 90;        // link::kByDeadline is SCHED_DEADLINE
  double runtime = 0.3;     // with that: share of the period that it may run
  int wake_latency_us = 0;  // how late processors may wake from idling; -1 is as they like
  YAML::Node
      params;  // of the type: a map, perhaps empty. Read it with Reader (reader.h): its mistakes have places, too
  Place place;
};

enum class Scheduling : std::uint8_t { kFifo, kOther, kDeadline };

struct ThreadConfig {
  std::string name;
  std::string host;  // threads of one host share a process
  Scheduling scheduling = Scheduling::kFifo;
  int priority = 60;     // link::kByDeadline is SCHED_DEADLINE
  double runtime = 0.3;  // with that: share of the period that it may run
  std::chrono::microseconds period{1000};
  std::optional<int> core;
  Place place;
};

// NOLINTNEXTLINE(bugprone-exception-escape): a YAML::Node can only be copied, which throws of one that is not there
struct PluginConfig {
  std::string name;
  std::string type;    // the library is lib<type>.so
  std::string thread;  // empty for io_plugins: they run in the communication handler
  YAML::Node params;   // a map, perhaps empty
  Place place;
};

// Plugins that are started and stopped together, by name.
struct SwitchGroup {
  std::string name;
  std::vector<std::string> start;
  std::vector<std::string> stop;
};

struct RtConfig {
  std::filesystem::path file;
  RobotDescription robot;
  std::string model_type;       // KDL or MUJOCO
  std::string master;           // the framework that may command: ROS or robotui
  bool enable_ref_read = true;  // frameworks see the references in force, too
  HalConfig hal;
  std::vector<ThreadConfig> threads;
  std::vector<PluginConfig> plugins;
  std::vector<PluginConfig> io_plugins;
  std::vector<PluginConfig> nrt_plugins;
  std::vector<SwitchGroup> switch_groups;
  std::vector<std::string> warnings;  // older names, keys that nobody knows
};

// What the command line changes.
struct Overrides {
  bool dummy = false;
  std::optional<std::chrono::microseconds> period;
};

// Throws ConfigError. Paths in the file are relative to the file.
RtConfig load(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace robotui::rt::config
