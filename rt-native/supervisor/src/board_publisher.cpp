#include "robotui/rt/supervisor/board_publisher.h"

#include <algorithm>

namespace robotui::rt::supervisor {
namespace {

void fillRobot(link::BoardData& data, const config::RtConfig& config) {
  const config::RobotDescription& robot = config.robot;
  link::assign(data.robot, robot.name);
  link::assign(data.hal, config.hal.type);
  data.joints = static_cast<std::uint32_t>(robot.joints.size());
  data.imus = static_cast<std::uint32_t>(robot.imus.size());
  data.force_torques = static_cast<std::uint32_t>(robot.force_torques.size());
  for (std::uint32_t i = 0; i < data.joints; ++i) {
    const config::JointDescription& joint = robot.joints[i];
    auto& entry = data.joint[i];
    link::assign(entry.name, joint.name);
    entry.id = joint.id;
    entry.type = joint.type == config::JointType::kPrismatic ? 1 : 0;
    entry.lower = joint.lower;
    entry.upper = joint.upper;
    entry.velocity = joint.velocity;
    entry.effort = joint.effort;
  }
  for (std::uint32_t i = 0; i < data.imus; ++i) {
    link::assign(data.imu[i], robot.imus[i].name);
  }
  for (std::uint32_t i = 0; i < data.force_torques; ++i) {
    link::assign(data.force_torque[i], robot.force_torques[i].name);
  }
}

void fillChains(link::BoardData& data, const config::RobotDescription& robot) {
  data.chains = static_cast<std::uint32_t>(std::min<std::size_t>(robot.chains.size(), link::kMaxChains));
  for (std::uint32_t i = 0; i < data.chains; ++i) {
    auto& entry = data.chain[i];
    link::assign(entry.name, robot.chains[i].name);
    for (const std::string& joint : robot.chains[i].joints) {
      const auto found =
          std::find_if(robot.joints.begin(), robot.joints.end(), [&](const auto& each) { return each.name == joint; });
      if (found != robot.joints.end() && entry.joints < link::kMaxJoints) {
        entry.joint[entry.joints++] = static_cast<std::uint16_t>(found - robot.joints.begin());
      }
    }
  }
}

void fillPlan(link::BoardData& data, const config::Plan& plan) {
  data.hosts = static_cast<std::uint32_t>(plan.hosts.size());
  for (std::uint32_t i = 0; i < data.hosts; ++i) {
    link::assign(data.host[i].name, plan.hosts[i].name);
    data.host[i].threads = static_cast<std::uint32_t>(plan.hosts[i].threads.size());
  }
  data.plugins = static_cast<std::uint32_t>(plan.plugins.size());
  for (std::uint32_t i = 0; i < data.plugins; ++i) {
    const config::PluginPlan& planned = plan.plugins[i];
    auto& entry = data.plugin[i];
    link::assign(entry.name, planned.plugin.name);
    link::assign(entry.type, planned.plugin.type);
    entry.host = planned.host;
    entry.thread = planned.thread;
    entry.io = plan.hosts[planned.host].kind == config::HostKind::kIo ? 1 : 0;
  }
}

}  // namespace

BoardPublisher::BoardPublisher(const config::RtConfig& config, const config::Plan& plan, bool real_time)
    : segment_(link::Segment<link::BoardSegment>::create(1)), writer_(*segment_) {
  fillRobot(writer_.edit(), config);
  fillChains(writer_.edit(), config.robot);
  fillPlan(writer_.edit(), plan);
  writer_.edit().real_time = real_time ? 1 : 0;
  segment_.sealAgainstWriters();
  publish();
}

void BoardPublisher::publish() noexcept {
  if (dirty_) {
    writer_.publish();
    dirty_ = false;
  }
}

void BoardPublisher::release(std::uint32_t joint, std::uint32_t plugin) noexcept {
  if (owner(joint) == plugin) {
    writer_.release(joint);
  }
}

}  // namespace robotui::rt::supervisor
