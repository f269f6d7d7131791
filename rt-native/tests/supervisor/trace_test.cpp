// What robotui-rt-ctl writes of a robot as it is shipped.
#include <gtest/gtest.h>

#include "homing.h"

namespace robotui::rt::supervisor {
namespace {

TEST(Traces, HaveTheCyclesAndThePluginThatRuns) {
  RunningRobot robot{WholeConfig{YAML::Dump(shipped("arm", "dummy"))}};
  robot.client();
  ASSERT_TRUE(robot.ask("switch JointTrajectory 1").ok);
  const auto file = robot.config().parent_path() / "trace.json";
  std::map<std::string, int> seen;
  // A machine that is busy sees little of it at a time.
  ASSERT_TRUE(eventually([&] {
    const auto [code, said] = robot.ctl("trace " + file.string() + " --for 0.3");
    EXPECT_EQ(code, 0) << said;
    for (const auto& event : YAML::LoadFile(file.string())["traceEvents"]) ++seen[event["name"].as<std::string>()];
    return seen["late"] > 20 && seen["JointTrajectory"] > 5 && seen["wake-up"] > 5;
  }));
  EXPECT_GT(seen["thread_name"], 2);
}

}  // namespace
}  // namespace robotui::rt::supervisor
