#include "messages.h"

#include <algorithm>
#include <bitset>
#include <cmath>

#include <google/protobuf/stubs/logging.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/model.pb.h>
#include <ignition/msgs/world_stats.pb.h>
#include <ignition/msgs/wrench.pb.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::size_t kLongest = 1 << 20;  // bytes
constexpr std::int64_t kMostSeconds = 4'000'000'000;
constexpr double kNoTurn = 1e-6;  // length of a quaternion that says nothing

template <class Message>
std::optional<Message> parsed(Bytes bytes) {
  // Else whoever sends broken messages fills the log of this process.
  [[maybe_unused]] static google::protobuf::LogHandler* const was_told = google::protobuf::SetLogHandler(nullptr);
  Message message;
  if (bytes.size() > kLongest || !message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return {};
  return message;
}

std::optional<std::int64_t> toNs(const ignition::msgs::Time& time) {
  if (time.sec() < 0 || time.sec() > kMostSeconds || time.nsec() < 0 || time.nsec() >= link::kSecond) return {};
  return time.sec() * link::kSecond + time.nsec();
}

bool isNumber(const JointSample& joint) {
  return std::isfinite(joint.position) && std::isfinite(joint.velocity) && std::isfinite(joint.effort);
}

bool take(const ignition::msgs::Vector3d& from, std::array<double, 3>& into) {
  into = {from.x(), from.y(), from.z()};
  return std::all_of(into.begin(), into.end(), [](double value) { return std::isfinite(value); });
}

// A sensor without orientation sends zeros, or nothing: then it does not turn.
bool takeTurn(const ignition::msgs::Quaternion& from, std::array<double, 4>& into) {
  const double length = std::hypot(std::hypot(from.x(), from.y()), std::hypot(from.z(), from.w()));
  if (!std::isfinite(length)) return false;
  into = {0, 0, 0, 1};
  if (length > kNoTurn) into = {from.x() / length, from.y() / length, from.z() / length, from.w() / length};
  return true;
}

}  // namespace

bool isType(std::string_view full_name, std::string_view message) noexcept {
  for (const std::string_view package : {"ignition.msgs.", "gz.msgs."}) {
    if (full_name.starts_with(package) && full_name.substr(package.size()) == message) return true;
  }
  return false;
}

JointsReading readJoints(Bytes message, const JointIndex& index, Sample& into) {
  const auto model = parsed<ignition::msgs::Model>(message);
  const auto stamp = model ? toNs(model->header().stamp()) : std::nullopt;
  if (!stamp) return {Reading::kUnreadable, 0};
  into.stamp_ns = *stamp;
  std::bitset<link::kMaxJoints> seen;
  for (const auto& joint : model->joint()) {
    const auto known = index.find(joint.name());
    if (known == index.end() || !joint.has_axis1()) continue;
    const std::size_t i = known->second;
    into.joints[i] = {joint.axis1().position(), joint.axis1().velocity(), joint.axis1().force()};
    if (!isNumber(into.joints[i])) return {Reading::kNoNumber, i};
    seen.set(i);
  }
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (!seen.test(i)) return {Reading::kLacksJoint, i};
  }
  return {Reading::kSound, 0};
}

std::vector<std::string> jointNames(Bytes message, std::size_t most) {
  std::vector<std::string> names;
  const auto model = parsed<ignition::msgs::Model>(message);
  if (!model) return names;
  for (const auto& joint : model->joint()) {
    if (names.size() < most) names.push_back(joint.name());
  }
  return names;
}

std::optional<link::ImuState> readImu(Bytes message) {
  const auto imu = parsed<ignition::msgs::IMU>(message);
  link::ImuState state{};
  if (!imu || !takeTurn(imu->orientation(), state.orientation) ||
      !take(imu->angular_velocity(), state.angular_velocity) ||
      !take(imu->linear_acceleration(), state.linear_acceleration))
    return {};
  return state;
}

std::optional<link::ForceTorqueState> readWrench(Bytes message) {
  const auto wrench = parsed<ignition::msgs::Wrench>(message);
  link::ForceTorqueState state{};
  if (!wrench || !take(wrench->force(), state.force) || !take(wrench->torque(), state.torque)) return {};
  return state;
}

std::optional<WorldState> readStatistics(Bytes message) {
  const auto statistics = parsed<ignition::msgs::WorldStatistics>(message);
  const auto time = statistics ? toNs(statistics->sim_time()) : std::nullopt;
  if (!time || !std::isfinite(statistics->real_time_factor())) return {};
  return WorldState{*time, statistics->paused(), statistics->real_time_factor()};
}

}  // namespace robotui::rt::hal::gazebo
