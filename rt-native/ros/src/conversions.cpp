#include "conversions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robotui::rt::ros_bridge {
namespace {

std::uint16_t degrees(float temperature) {
  return std::isfinite(temperature) ? static_cast<std::uint16_t>(std::clamp(temperature, 0.0F, 65535.0F))
                                    : std::uint16_t{0};
}

template <typename T, typename Value>
void column(std::vector<T>& into, std::span<const link::JointState> joints, Value&& value) {
  into.resize(joints.size());
  std::transform(joints.begin(), joints.end(), into.begin(),
                 [&](const link::JointState& joint) { return static_cast<T>(value(joint)); });
}

// The bits of the mode, and the arrays that they ask for.
struct Part {
  std::uint8_t bit;
  const char* field;
  double link::JointCommand::*value;
};
constexpr Part kParts[] = {{link::kPosition, "position", &link::JointCommand::position},
                           {link::kVelocity, "velocity", &link::JointCommand::velocity},
                           {link::kEffort, "effort", &link::JointCommand::effort},
                           {link::kStiffness, "stiffness", &link::JointCommand::stiffness},
                           {link::kDamping, "damping", &link::JointCommand::damping}};
constexpr int kAllModes = 31;

const std::vector<double>& numbers(const Columns& columns, std::string_view field) {
  static const std::vector<double> kNone;
  const auto found = columns.numbers.find(field);
  return found == columns.numbers.end() ? kNone : found->second;
}

std::string readJoint(const Columns& columns, std::size_t row, const std::string& name, link::JointCommand& command) {
  const double mode = numbers(columns, "ctrl_mode")[row];
  if (mode < 0 || mode > kAllModes)
    return "ctrl_mode of " + name + " is " + std::to_string(static_cast<int>(mode)) + ", and 31 is all that there is";
  command.mode = static_cast<std::uint8_t>(mode);
  for (const Part& part : kParts) {
    if ((command.mode & part.bit) == 0) continue;
    const auto& values = numbers(columns, part.field);
    if (row >= values.size()) return "ctrl_mode of " + name + " asks for its " + part.field + ", which is not there";
    if (!std::isfinite(values[row])) return std::string("the ") + part.field + " of " + name + " is no number";
    command.*part.value = values[row];
  }
  return {};
}

}  // namespace

std::string rosName(std::string_view name) {
  std::string result(name);
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; }, '_');
  return result;
}

void fill(xbot_msgs::JointState& message, std::span<const std::string> names,
          std::span<const link::JointState> joints) {
  if (message.name.size() != names.size()) message.name.assign(names.begin(), names.end());
  column(message.link_position, joints, [](const auto& j) { return j.link_position; });
  column(message.motor_position, joints, [](const auto& j) { return j.motor_position; });
  column(message.link_velocity, joints, [](const auto& j) { return j.link_velocity; });
  column(message.motor_velocity, joints, [](const auto& j) { return j.motor_velocity; });
  column(message.effort, joints, [](const auto& j) { return j.effort; });
  column(message.temperature_motor, joints, [](const auto& j) { return degrees(j.temperature_motor); });
  column(message.temperature_driver, joints, [](const auto& j) { return degrees(j.temperature_driver); });
  column(message.position_reference, joints, [](const auto& j) { return j.position_reference; });
  column(message.velocity_reference, joints, [](const auto& j) { return j.velocity_reference; });
  column(message.effort_reference, joints, [](const auto& j) { return j.effort_reference; });
  column(message.stiffness, joints, [](const auto& j) { return j.stiffness; });
  column(message.damping, joints, [](const auto& j) { return j.damping; });
  // A fault of the upper bits may not look like none.
  column(message.fault, joints,
         [](const auto& j) { return (j.fault & 0xffffU) != 0 || j.fault == 0 ? j.fault & 0xffffU : 0x8000U; });
}

void hideReferences(xbot_msgs::JointState& message) {
  for (auto* const column : {&message.position_reference, &message.velocity_reference, &message.effort_reference,
                             &message.stiffness, &message.damping}) {
    std::fill(column->begin(), column->end(), std::numeric_limits<float>::quiet_NaN());
  }
}

void fill(sensor_msgs::Imu& message, const link::ImuState& imu) {
  message.orientation.x = imu.orientation[0];
  message.orientation.y = imu.orientation[1];
  message.orientation.z = imu.orientation[2];
  message.orientation.w = imu.orientation[3];
  message.angular_velocity.x = imu.angular_velocity[0];
  message.angular_velocity.y = imu.angular_velocity[1];
  message.angular_velocity.z = imu.angular_velocity[2];
  message.linear_acceleration.x = imu.linear_acceleration[0];
  message.linear_acceleration.y = imu.linear_acceleration[1];
  message.linear_acceleration.z = imu.linear_acceleration[2];
}

void fill(geometry_msgs::WrenchStamped& message, const link::ForceTorqueState& sensor) {
  message.wrench.force.x = sensor.force[0];
  message.wrench.force.y = sensor.force[1];
  message.wrench.force.z = sensor.force[2];
  message.wrench.torque.x = sensor.torque[0];
  message.wrench.torque.y = sensor.torque[1];
  message.wrench.torque.z = sensor.torque[2];
}

std::string readCommand(const Columns& columns, std::span<const std::string> names,
                        std::vector<link::JointCommand>& commands) {
  commands.assign(names.size(), link::JointCommand{});
  const auto joints = columns.texts.find("name");
  if (joints == columns.texts.end() || joints->second.empty()) return "it names no joint";
  const auto& modes = numbers(columns, "ctrl_mode");
  if (modes.size() != joints->second.size()) {
    return "it has " + std::to_string(joints->second.size()) + " names and " + std::to_string(modes.size()) +
           " of ctrl_mode";
  }
  for (std::size_t row = 0; row < modes.size(); ++row) {
    const std::string& name = joints->second[row];
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return "the robot has no joint '" + name.substr(0, 64) + "'";
    std::string objection = readJoint(columns, row, name, commands[static_cast<std::size_t>(found - names.begin())]);
    if (!objection.empty()) return objection;
  }
  return {};
}

}  // namespace robotui::rt::ros_bridge
