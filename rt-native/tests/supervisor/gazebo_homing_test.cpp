// The same Homing, as it is shipped, for robots in a world of another process, which is lost and found.
#include <signal.h>

#include <memory>

#include "../hal_gazebo/world_process.h"
#include "homing.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::supervisor {
namespace {

class GazeboHoming : public ::testing::TestWithParam<const char*> {
 protected:
  YAML::Node config() const {
    YAML::Node config = shipped(GetParam(), "gazebo");
    config["HALInterface"]["params"]["partition"] = partition_;
    return config;
  }

  // With the joints of the robot, and its sensors' topics.
  std::unique_ptr<WorldProcess> world() const {
    const std::string robot = GetParam();
    const auto folder = std::filesystem::path(RT_CONFIGS) / robot;
    std::string joints;
    for (const auto& joint : config::load(folder / "rt-gazebo.yaml", {}).robot.joints)
      joints += (joints.empty() ? "" : ",") + joint.name;
    return std::make_unique<WorldProcess>(
        std::vector<std::string>{"partition=" + partition_, "model=" + robot, "joints=" + joints,
                                 "imu=/world/default/model/humanoid/link/imu_link/sensor/imu/imu"});
  }

  std::string partition_ = ownPartition();
};

TEST_P(GazeboHoming, TakesTheRobotHome) {
  const auto simulator = world();
  expectHome(config(), "home");
}

INSTANTIATE_TEST_SUITE_P(Gazebo, GazeboHoming, ::testing::Values("arm", "humanoid"));

using GazeboLoss = GazeboHoming;

TEST_P(GazeboLoss, MakesTheRobotSafeUntilPluginsAreStartedAnew) {
  auto simulator = world();
  YAML::Node config = this->config();
  config["HALInterface"]["misses_before_safe"] = 20;
  RunningRobot robot(WholeConfig{YAML::Dump(config)});
  robot.client();
  const auto wanted = goals(config::load(robot.config(), {}).robot, "home");
  ASSERT_TRUE(robot.ask("switch Homing 1").ok) << robot.output();
  const auto is = [&](std::uint32_t hal, link::Control control) {
    return eventually([&] {
      const auto frame = robot.frame();
      return frame->hal_status == hal && frame->joints[0].control == static_cast<std::uint8_t>(control);
    });
  };
  simulator.reset();
  EXPECT_TRUE(is(1, link::Control::kSafe)) << robot.output();
  EXPECT_TRUE(eventually([&] {
    return robot.output().find("all others of the model 'arm' are silent") != std::string::npos;
  })) << robot.output();
  simulator = world();
  EXPECT_TRUE(is(0, link::Control::kSafe)) << robot.output();
  EXPECT_TRUE(robot.ask("switch Homing 0").ok);
  expectHomeOf(robot, wanted);
  EXPECT_EQ(robot.end(SIGTERM), 0) << robot.output();
  EXPECT_EQ(simulator->say("listeners"), "none");
}

INSTANTIATE_TEST_SUITE_P(Gazebo, GazeboLoss, ::testing::Values("arm"));

}  // namespace
}  // namespace robotui::rt::supervisor
