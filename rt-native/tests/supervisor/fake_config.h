// A robot with four joints and plugins that want them.
#pragma once

#include "robotui/rt/config/plan.h"

namespace robotui::rt::supervisor {

inline config::PluginConfig pluginOf(const std::string& name, const std::string& type, const std::string& thread) {
  return {name, type, thread, YAML::Node(YAML::NodeType::Map), {}};
}

inline config::RtConfig fakeConfig() {
  config::RtConfig config{};
  config.file = "/fake.yaml";
  config.robot.name = "fake";
  for (int i = 1; i <= 4; ++i) {
    config::JointDescription joint{};
    joint.id = i;
    joint.name = "j" + std::to_string(i);
    config.robot.joints.push_back(joint);
  }
  config::ThreadConfig fast{};
  fast.name = "fast";
  fast.host = "rt";
  config::ThreadConfig slow = fast;
  slow.name = "slow";
  slow.period = std::chrono::microseconds(4000);
  config::ThreadConfig apart = fast;
  apart.name = "apart";
  apart.host = "other";
  config.threads = {fast, slow, apart};
  config.plugins = {pluginOf("homing", "Homing", "fast"), pluginOf("sine", "Sine", "slow"),
                    pluginOf("reach", "Reach", "apart"), pluginOf("log", "Recorder", "slow"),
                    pluginOf("bridge", "OwnMaster", "fast")};
  config.io_plugins = {pluginOf("face", "Face", "")};
  config.nrt_plugins = {pluginOf("slowly", "Sine", "fast")};
  return config;
}

}  // namespace robotui::rt::supervisor
