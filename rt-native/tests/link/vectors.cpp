#include "vectors.h"

#include <limits>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/command.h"
#include "robotui/rt/link/histogram.h"

namespace robotui::rt::link {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Header headerOf(SegmentKind kind, std::size_t size) {
  return {.magic = kMagic,
          .version = kLayoutVersion,
          .segment = static_cast<std::uint32_t>(kind),
          .generation = 3,
          .created_ns = 123'456'789'012'345,
          .pid = 4711,
          .size = static_cast<std::uint32_t>(size)};
}

JointState jointOf(int index) {
  const double i = index;
  return {.link_position = 0.125 + i,
          .motor_position = 0.1 + i,
          .link_velocity = -1.5 - i,
          .motor_velocity = -1.25 - i,
          .effort = 1e-3 + i,
          .position_reference = 0.5 + i,
          .velocity_reference = 1.0 / 3.0 + i,
          .effort_reference = 12.75 + i,
          .stiffness = 1000 + i,
          .damping = 10 + i,
          .temperature_motor = 41.5F,
          .temperature_driver = std::numeric_limits<float>::quiet_NaN(),
          .fault = 0x80000001U,
          .clamped = 7,
          .rejected = 4'000'000'000U,
          .owner = static_cast<std::uint16_t>(index),
          .mode = kImpedance,
          .control = static_cast<std::uint8_t>(Control::kHolding)};
}

}  // namespace

std::unique_ptr<StateFrame> stateFrameVector() {
  auto frame = std::make_unique<StateFrame>();
  frame->sequence = 84;
  frame->data.cycle = 9'007'199'254'740'993;  // no double has it
  frame->data.sensed_ns = 1'234'567'890'123;
  frame->data.hal_status = 1;
  for (const int i : {0, 1, 127}) frame->data.joints[static_cast<std::size_t>(i)] = jointOf(i);
  frame->data.joints[1].owner = kNobody;
  frame->data.imus[7] = {{0, 0, 0.70710678118654752, 0.70710678118654752}, {0.1, -0.2, 0.3}, {0, 0, 9.80665}};
  frame->data.force_torques[15] = {{1, -2, 3}, {-0.5, 0.25, 1e-300}};
  return frame;
}

std::unique_ptr<HostSegment> hostSegmentVector() {
  auto host = std::make_unique<HostSegment>();
  host->header = headerOf(SegmentKind::kHost, sizeof(HostSegment));
  host->threads = 2;
  CommandData command{};
  command.cycle = 1234;
  command.written_ns = 1'234'567'990'123;
  command.joints[0] = {0.5, 1.5, -2.5, 300, 3, 5, kPosition | kImpedance, {}};
  command.joints[127] = {-0.5, -1.5, kInfinity, 0, 0, 63, kEffort, {}};
  SlotWriter(*host, 1, kMaxJoints).write(command);
  ThreadStatistics& thread = host->thread_statistics[1];
  assign(thread.name, "rt_main");
  thread.period_ns = 1'000'000;
  thread.priority = 60;
  thread.core = -1;
  thread.inside = kNobody;
  thread.cycles = 1234;
  record(thread.wake_up, 5'000);
  record(thread.wake_up, 64);
  PluginStatistics& plugin = host->plugins[5];
  plugin.state = static_cast<std::uint32_t>(PluginState::kRunning);
  plugin.thread = 1;
  plugin.cycles = 77;
  plugin.last_busy_ns = 12'345;
  record(plugin.busy, 12'345);
  return host;
}

std::unique_ptr<BoardSegment> boardVector() {
  auto board = std::make_unique<BoardSegment>();
  board->header = headerOf(SegmentKind::kBoard, sizeof(BoardSegment));
  BoardWriter writer(*board);
  BoardData& data = writer.edit();
  data.joints = 2;
  data.imus = data.force_torques = data.hosts = data.plugins = data.real_time = data.hal_respawns = 1;
  data.hal_pid = 4712;
  assign(data.robot, "Gr\u00fcner Arm");
  assign(data.hal, "dummy");
  assign(data.joint[0].name, "shoulder_pan");
  data.joint[0].id = 11;
  data.joint[0].lower = -kInfinity;
  data.joint[0].upper = kInfinity;
  data.joint[0].velocity = 3.15;
  data.joint[0].effort = 87;
  assign(data.joint[1].name, "lift");
  data.joint[1].id = 12;
  data.joint[1].type = 1;
  data.joint[1].lower = -0.25;
  data.joint[1].upper = 0.75;
  assign(data.imu[0], "imu_link");
  assign(data.force_torque[0], "wrist");
  assign(data.host[0].name, "main");
  data.host[0].pid = 4713;
  data.host[0].respawns = 2;
  data.host[0].threads = 2;
  assign(data.plugin[0].name, "homing");
  assign(data.plugin[0].type, "Homing");
  data.plugin[0].thread = 1;
  data.plugin[0].state = static_cast<std::uint32_t>(PluginState::kFailed);
  assign(data.plugin[0].error, "The joint 'elbow' is not one of this robot.");
  assign(data.plugin[0].status, "waits");
  data.chains = 1;
  assign(data.chain[0].name, "arm");
  data.chain[0].joints = 2;
  data.chain[0].joint[0] = 1;
  writer.publish();
  writer.grant(0, 0);
  writer.grant(0, 0);
  writer.grant(1, 0);
  writer.release(1);
  return board;
}

}  // namespace robotui::rt::link
