// The safe law against the simulation, which knows nothing of the model that it is computed with.
#include <gtest/gtest.h>

#include "mujoco_hal.h"
#include "../hal/silent_plugin.h"

namespace robotui::rt::hal {
namespace {

class SafeLawInSimulation : public testing::Test {
 protected:
  SafeLawInSimulation() {
    config::HalConfig config;
    config.type = "mujoco";
    config.params = YAML::Load("{}");
    hardware_.open(*arm_, config, SilentPlugin::kPeriod);
  }
  RobotPtr arm_ = robotNamed("arm");
  MujocoHal hardware_;
};

TEST_F(SafeLawInSimulation, HoldsTheArmWhoseEffortsNobodyCommandsAnyMore) {
  const auto law = makeGravityTorque(arm_, "KDL");
  SilentPlugin robot(arm_, hardware_, *law);
  ASSERT_TRUE(robot.isSafe());
  const link::FrameData before = robot.frame();
  robot.run(2000);
  EXPECT_LT(robot.movedFrom(before), 0.05);
  EXPECT_GT(robot.mostEffort(), 10) << "it carries the arm";
}

TEST_F(SafeLawInSimulation, WithDampingAloneItFalls) {
  NoTorque law;
  SilentPlugin robot(arm_, hardware_, law);
  const link::FrameData before = robot.frame();
  robot.run(2000);
  EXPECT_GT(robot.movedFrom(before), 0.2);
}

}  // namespace
}  // namespace robotui::rt::hal
