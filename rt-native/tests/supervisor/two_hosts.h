// Two hosts: a bad plugin in one, a good one in the other.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "robotui/rt/link/state.h"
#include "running_robot.h"

namespace robotui::rt::supervisor {

inline constexpr const char* kTwoHosts = R"(
xbotcore_threads:
  first: {sched: fifo, prio: 60, period: 0.001, host: a}
  second: {sched: fifo, prio: 55, period: 0.002, host: b}
xbotcore_plugins:
  bad: {thread: first, type: Naughty, params: {joints: [shoulder_yaw]}}
  good: {thread: second, type: Naughty, params: {joints: [elbow_pitch]}}
  rival: {thread: second, type: Naughty, params: {joints: [shoulder_yaw, elbow_pitch]}}
)";

// A plugin that is late falls, and is stopped: not where that is not what is looked at.
inline constexpr int kPatient = 1000;

inline void expectOk(const link::Reply& reply) { EXPECT_TRUE(reply.ok) << reply.text; }
inline void expectIn(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

inline const link::JointState& joint(const link::FrameData& frame, std::uint32_t index) { return frame.joints[index]; }

// Whether the plugin commands its joint when it is started. A machine that is late twice makes the joint safe: then it
// is started again.
inline bool commands(RunningRobot& robot, const std::string& plugin, std::uint32_t index) {
  return eventually([&] {
    const auto control = static_cast<link::Control>(joint(*robot.frame(), index).control);
    // One that fell in this moment is still being stopped.
    if (control != link::Control::kCommanded) robot.ask("switch " + plugin + " 1");
    return control == link::Control::kCommanded;
  });
}

}  // namespace robotui::rt::supervisor
