// What lies in the shared memory: written once here, described for other languages in link/layout.txt, and checked
// against it by the tests of both sides. All numbers are SI (rad, m, N m, N, s), little endian; times are nanoseconds
// of CLOCK_MONOTONIC.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace robotui::rt::link {

// Rises with every change of what follows, but for a field in bytes that were zero before; both sides refuse another
// one.
inline constexpr std::uint32_t kLayoutVersion = 2;
inline constexpr std::uint32_t kMagic = 0x54524952;  // "RIRT"

inline constexpr std::uint32_t kMaxJoints = 128;
inline constexpr std::uint32_t kMaxImus = 8;
inline constexpr std::uint32_t kMaxForceTorques = 16;
inline constexpr std::uint32_t kMaxHosts = 8;
inline constexpr std::uint32_t kMaxThreads = 8;   // of one host
inline constexpr std::uint32_t kMaxPlugins = 64;  // of all hosts
inline constexpr std::uint32_t kMaxChains = 32;
inline constexpr std::uint32_t kFrames = 1024;  // who wants every cycle may be so many behind: a second at 1 kHz
inline constexpr std::uint32_t kBuckets = 96;
inline constexpr std::uint32_t kNameLength = 64;
inline constexpr std::uint32_t kTextLength = 512;
inline constexpr std::uint16_t kNobody = 0xffff;  // no plugin owns the joint

static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<std::uint32_t>::is_always_lock_free);

// What a joint is told, as bits (those of XBot).
enum Mode : std::uint8_t { kPosition = 1, kVelocity = 2, kEffort = 4, kStiffness = 8, kDamping = 16, kImpedance = 24 };

// Who the reference of a joint comes from in this cycle.
enum class Control : std::uint8_t {
  kFree = 0,       // no plugin owns it: it holds
  kCommanded = 1,  // its plugin's command of this cycle (or of its thread's period)
  kHolding = 2,    // its plugin missed: hold per mode
  kSafe = 3        // its plugin missed too often, or its host died: safe state, until it is started again
};

enum class SegmentKind : std::uint32_t { kState = 1, kBoard = 2, kHost = 3, kMaster = 4, kChannels = 5 };

struct Header {
  std::uint32_t magic;
  std::uint32_t version;
  std::uint32_t segment;     // of SegmentKind
  std::uint32_t generation;  // counts the processes that wrote it: another one means attach again
  std::int64_t created_ns;
  std::int32_t pid;    // of the writer
  std::uint32_t size;  // of the whole segment, bytes
};

using Name = std::array<char, kNameLength>;  // UTF-8, zero terminated
using Text = std::array<char, kTextLength>;

// Bucket i counts values in [lower(i), lower(i+1)), four buckets of one width an octave from 64 ns:
//   lower(i) = (4 + i % 4) << (4 + i / 4)
// The first bucket has all below, too, the last one all above. One writer; readers may see a count that is one behind.
struct Histogram {
  std::uint64_t count;
  std::int64_t max_ns;
  std::array<std::uint32_t, kBuckets> buckets;
};

// ---- state: the HAL writes, all read --------------------------------------------------------------------------------

struct JointState {
  double link_position;
  double motor_position;
  double link_velocity;
  double motor_velocity;
  double effort;
  double position_reference;  // the references are those that went to the hardware, after limits
  double velocity_reference;
  double effort_reference;
  double stiffness;
  double damping;
  float temperature_motor;  // degree Celsius; NaN where unknown
  float temperature_driver;
  std::uint32_t fault;     // bits of the hardware; 0 is well
  std::uint32_t clamped;   // commands that a limit cut, since the HAL started
  std::uint32_t rejected;  // commands that were no numbers or not allowed
  std::uint16_t owner;     // plugin, or kNobody
  std::uint8_t mode;       // bits of Mode
  std::uint8_t control;    // of Control
};

struct ImuState {
  std::array<double, 4> orientation;  // x y z w, of the sensor in the world
  std::array<double, 3> angular_velocity;
  std::array<double, 3> linear_acceleration;
};

struct ForceTorqueState {
  std::array<double, 3> force;
  std::array<double, 3> torque;
};

struct FrameData {
  std::uint64_t cycle;  // from 1
  std::int64_t sensed_ns;
  std::uint32_t hal_status;  // of hal::Status
  std::uint32_t switched;    // the last group of plugins that was switched, from this cycle on or before; 0 is none
  std::array<JointState, kMaxJoints> joints;
  std::array<ImuState, kMaxImus> imus;
  std::array<ForceTorqueState, kMaxForceTorques> force_torques;
};

struct StateFrame {
  std::atomic<std::uint64_t> sequence;  // odd while the data is written
  FrameData data;
};

struct LoopStatistics {
  std::int64_t period_ns;
  std::int32_t priority;  // SCHED_FIFO; 0 is not real time, 100 is SCHED_DEADLINE
  std::int32_t core;      // -1 is any
  std::uint64_t cycles;
  std::uint64_t overruns;  // points of the grid at which no cycle could begin, since the one before was not done
  std::uint64_t sense_failures;
  std::uint64_t move_failures;
  std::uint64_t missed_commands;  // of all plugin threads
  std::uint64_t allocations;      // seen in cycles, where the counter is built in; else 0
  std::uint64_t page_faults;      // of the loop's thread since its first cycle
  Histogram wake_up;              // how late it woke
  Histogram period;               // between two starts
  Histogram busy;                 // what one cycle took
};

struct StateSegment {
  Header header;
  std::atomic<std::uint64_t> newest;  // cycle of the newest whole frame; frame = cycle % kFrames; 0 is none yet
  std::atomic<std::uint32_t> bell;    // futex: rises with every frame
  std::uint32_t joints;
  std::uint32_t imus;
  std::uint32_t force_torques;
  LoopStatistics loop;
  std::array<StateFrame, kFrames> frames;
};

// ---- host: one plugin host writes, the HAL and all others read ------------------------------------------------------

struct JointCommand {
  double position;
  double velocity;
  double effort;
  double stiffness;
  double damping;
  std::uint16_t plugin;  // who says so: it must own the joint
  std::uint8_t mode;     // what of it is meant, bits of Mode; 0 is nothing
  std::uint8_t padding[5];
};

struct CommandData {
  std::uint64_t cycle;  // the state's cycle that it answers
  std::int64_t written_ns;
  std::array<JointCommand, kMaxJoints> joints;
};

struct CommandSlot {                    // of one thread
  std::atomic<std::uint64_t> sequence;  // odd while the data is written; 0 is never written
  CommandData data;
};

struct ThreadStatistics {
  Name name;
  std::int64_t period_ns;
  std::int32_t priority;  // SCHED_FIFO; 0 is not real time, 100 is SCHED_DEADLINE
  std::int32_t core;      // -1 is any
  std::atomic<std::uint32_t>
      inside;  // plugin whose code runs just now, or kNobody: to be named when the host is killed
  std::uint32_t padding;
  std::uint64_t cycles;
  std::uint64_t overruns;
  std::uint64_t allocations;
  std::uint64_t page_faults;
  Histogram wake_up;
  Histogram busy;
};

enum class PluginState : std::uint32_t {
  kAbsent = 0,
  kLoaded = 1,
  kStopped = 2,
  kStarting = 3,
  kRunning = 4,
  kStopping = 5,
  kFailed = 6
};

struct PluginStatistics {
  std::atomic<std::uint32_t> state;  // of PluginState, as the host sees it
  std::uint32_t thread;              // index in this host
  std::uint64_t cycles;
  std::int64_t last_busy_ns;
  Histogram busy;
};

struct HostSegment {
  Header header;
  std::atomic<std::uint32_t> bell;  // futex: rises with every command
  std::uint32_t threads;
  std::array<CommandSlot, kMaxThreads> slots;
  std::array<ThreadStatistics, kMaxThreads> thread_statistics;
  std::array<PluginStatistics, kMaxPlugins> plugins;  // by index on the board; others are kAbsent
};

// ---- master: the communication handler writes what the master framework wants, the communication plugin reads -------

struct MasterData {
  std::int64_t valid_until_ns;                  // afterwards the joints hold
  std::array<JointCommand, kMaxJoints> joints;  // `plugin` means nothing here
};

struct MasterSegment {
  Header header;
  std::atomic<std::uint64_t> sequence;  // odd while the data is written; 0 is never written
  MasterData data;
};

// ---- board: the supervisor writes, all read -------------------------------------------------------------------------

struct JointEntry {
  Name name;
  std::int32_t id;     // of the joint map
  std::uint32_t type;  // 0 revolute or continuous (rad), 1 prismatic (m)
  double lower;        // -inf and inf where there is no limit
  double upper;
  double velocity;
  double effort;
};

struct ChainEntry {
  Name name;
  std::uint32_t joints;
  std::uint32_t padding;
  std::array<std::uint16_t, kMaxJoints> joint;  // indices, from base to tip
};

struct PluginEntry {
  Name name;
  Name type;
  std::uint32_t host;    // index
  std::uint32_t thread;  // index in the host
  std::uint32_t state;   // of PluginState, as users see it
  std::uint32_t respawns;
  std::uint32_t io;  // 1: an IO plugin, in the communication handler
  std::uint32_t padding;
  Text error;   // why it failed, or is not started; empty where all is well
  Text status;  // what it says of itself
};

struct HostEntry {
  Name name;
  std::int32_t pid;  // 0 is none now
  std::uint32_t respawns;
  std::uint32_t threads;
  std::uint32_t padding;
  Text error;
};

struct BoardData {
  std::uint32_t joints;
  std::uint32_t imus;
  std::uint32_t force_torques;
  std::uint32_t hosts;
  std::uint32_t plugins;
  std::uint32_t real_time;  // 0: it runs without real-time rights, because it was allowed to
  std::uint32_t hal_respawns;
  std::int32_t hal_pid;
  std::uint32_t chains;
  std::uint32_t padding;
  Name robot;
  Name hal;
  std::array<JointEntry, kMaxJoints> joint;
  std::array<Name, kMaxImus> imu;
  std::array<Name, kMaxForceTorques> force_torque;
  std::array<HostEntry, kMaxHosts> host;
  std::array<PluginEntry, kMaxPlugins> plugin;
  std::array<ChainEntry, kMaxChains> chain;
};

struct BoardSegment {
  Header header;
  std::array<std::atomic<std::uint16_t>, kMaxJoints> owners;  // plugin of a joint, or kNobody
  std::array<std::atomic<std::uint32_t>, kMaxJoints> grants;  // rises when a joint is given anew: ends its safe state
  std::atomic<std::uint64_t> sequence;                        // odd while the data is written; 0 is never written
  BoardData data;
};

}  // namespace robotui::rt::link
