#include "settings.h"

#include <gtest/gtest.h>

#include "topics.h"

namespace robotui::rt::hal::gazebo {
namespace {

Settings settingsOf(const std::string& params) {
  config::RobotDescription robot{};
  robot.name = "arm";
  robot.joints.resize(2);
  robot.imus = {{"pelvis", "pelvis"}};
  robot.force_torques.resize(2);
  config::HalConfig config;
  config.params = YAML::Load(params);
  return readSettings(config, robot);
}

TEST(GazeboSettings, name_the_topics_of_the_simulators_own_systems) {
  const Settings settings = settingsOf("{}");
  const Topics topics(settings);
  EXPECT_EQ(topics.of(settings.topics.joint_state), "/world/default/model/arm/joint_state");
  EXPECT_EQ(topics.ofJoint(settings.topics.position, "elbow"), "/model/arm/joint/elbow/0/cmd_pos");
  EXPECT_EQ(topics.ofJoint(settings.topics.effort, "elbow"), "/model/arm/joint/elbow/cmd_force");
  EXPECT_EQ(topics.ofSensor(settings.topics.imu, {"pelvis", "pelvis"}),
            "/world/default/model/arm/link/pelvis/sensor/imu/imu");
}

TEST(GazeboSettings, take_other_names_and_topics) {
  const Settings settings = settingsOf(
      "{world: lab, model: left, timeout_us: 5000, at_end: pause, topics: {position: '/{model}/{joint}/goal', imu: "
      "/imu}}");
  const Topics topics(settings);
  EXPECT_EQ(topics.of(settings.topics.statistics), "/world/lab/stats");
  EXPECT_EQ(topics.ofJoint(settings.topics.position, "elbow"), "/left/elbow/goal");
  EXPECT_EQ(topics.ofSensor(settings.topics.imu, {"pelvis", "pelvis"}), "/imu");  // there is one alone
  EXPECT_EQ(settings.timeout_ns, 5'000'000);
  EXPECT_EQ(settings.at_end, AtEnd::kPause);
}

TEST(GazeboSettings, mistakes_are_named) {
  const auto expect = [&](const std::string& params, const std::string& said) {
    try {
      settingsOf(params);
      ADD_FAILURE() << "no mistake in " << params;
    } catch (const config::ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  };
  expect("{wrld: lab}", "did you mean 'world'?");
  expect("{at_end: stop}", "at_end");
  expect("{model: 'two words'}", "cannot be a part of a topic");
  expect("{timeout_us: 5}", "timeout_us");
  expect("{topics: {position: /cmd}}", "lacks {joint}");
  expect("{topics: {force_torque: /wrench}}", "lacks {sensor} or {link}");
  expect("{topics: {joint_state: 'no topic'}}", "is no topic");
  expect("{topics: {joint_state: '/{joint}'}}", "is no topic");
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
