#include "conversions.h"

#include <gtest/gtest.h>

#include <limits>

namespace robotui::rt::ros_bridge {
namespace {

const std::vector<std::string> kNames{"a", "b", "c"};

Columns columns(const std::vector<std::string>& names, const std::vector<double>& position,
                const std::vector<double>& mode) {
  Columns result;
  result.texts["name"] = names;
  result.numbers["position"] = position;
  result.numbers["ctrl_mode"] = mode;
  return result;
}

TEST(Conversions, StatesGetAColumnForEachValue) {
  std::vector<link::JointState> joints(3);
  joints[1].link_position = 0.25;
  joints[1].stiffness = 100;
  joints[1].temperature_motor = 41.7F;
  joints[1].temperature_driver = std::numeric_limits<float>::quiet_NaN();
  joints[1].fault = 5;
  joints[2].fault = 0x10000;
  xbot_msgs::JointState message;
  fill(message, kNames, joints);
  EXPECT_EQ(message.name, kNames);
  EXPECT_FLOAT_EQ(message.link_position[1], 0.25F);
  EXPECT_FLOAT_EQ(message.stiffness[1], 100.0F);
  EXPECT_EQ(message.temperature_motor[1], 41);
  EXPECT_EQ(message.temperature_driver[1], 0);
  EXPECT_EQ(message.fault[1], 5);
  EXPECT_NE(message.fault[2], 0) << "a fault of upper bits is one, too";
}

TEST(Conversions, SensorsKeepTheirAxes) {
  link::ImuState imu{{0.1, 0.2, 0.3, 0.9}, {1, 2, 3}, {4, 5, 6}};
  sensor_msgs::Imu message;
  fill(message, imu);
  EXPECT_EQ(message.orientation.w, 0.9);
  EXPECT_EQ(message.angular_velocity.y, 2);
  EXPECT_EQ(message.linear_acceleration.z, 6);
  geometry_msgs::WrenchStamped wrench;
  fill(wrench, link::ForceTorqueState{{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(wrench.wrench.force.z, 3);
  EXPECT_EQ(wrench.wrench.torque.x, 4);
}

TEST(Conversions, ACommandConcernsTheJointsThatItNames) {
  std::vector<link::JointCommand> commands;
  EXPECT_EQ(readCommand(columns({"c", "a"}, {0.5, 0.7}, {1, 1}), kNames, commands), "");
  ASSERT_EQ(commands.size(), 3u);
  EXPECT_EQ(commands[0].position, 0.7);
  EXPECT_EQ(commands[1].mode, 0);
  EXPECT_EQ(commands[2].position, 0.5);
}

TEST(Conversions, ACommandThatIsNoneSaysWhy) {
  std::vector<link::JointCommand> commands;
  EXPECT_NE(readCommand(columns({}, {}, {}), kNames, commands).find("names no joint"), std::string::npos);
  EXPECT_NE(readCommand(columns({"x"}, {0}, {1}), kNames, commands).find("no joint 'x'"), std::string::npos);
  EXPECT_NE(readCommand(columns({"a", "b"}, {0, 0}, {1}), kNames, commands).find("2 names and 1"), std::string::npos);
  EXPECT_NE(readCommand(columns({"a"}, {}, {1}), kNames, commands).find("asks for its position"), std::string::npos);
  EXPECT_NE(readCommand(columns({"a"}, {0}, {2}), kNames, commands).find("asks for its velocity"), std::string::npos);
  EXPECT_NE(readCommand(columns({"a"}, {0}, {64}), kNames, commands).find("31"), std::string::npos);
  EXPECT_NE(
      readCommand(columns({"a"}, {std::numeric_limits<double>::infinity()}, {1}), kNames, commands).find("no number"),
      std::string::npos);
}

TEST(Conversions, NamesOfRosHaveLettersDigitsAndUnderscores) { EXPECT_EQ(rosName("left-arm.1"), "left_arm_1"); }

}  // namespace
}  // namespace robotui::rt::ros_bridge
