#include "gazebo_hal.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::int64_t kGreeting = 3 * link::kSecond;
constexpr unsigned kControlMs = 1000;
constexpr std::chrono::milliseconds kTimeToLeave{50};  // for what was sent last: the transport has no flush
constexpr double kGravity = 9.80665;

std::vector<std::string> namesOf(const config::RobotDescription& robot) {
  std::vector<std::string> names;
  for (const config::JointDescription& joint : robot.joints) names.push_back(joint.name);
  return names;
}

// Until a sensor is heard it is as one at rest.
void measureRest(Measurements& into) noexcept {
  for (link::ImuState& imu : into.imus) {
    if (imu.orientation == std::array<double, 4>{}) imu = {{0, 0, 0, 1}, {0, 0, 0}, {0, 0, kGravity}};
  }
}

}  // namespace

void GazeboHal::open(const config::RobotDescription& robot, const config::HalConfig& config,
                     std::int64_t /*period_ns*/) {
  settings_ = readSettings(config, robot);
  cycles_after_reset_ = config.misses_before_safe + 1;
  notices_ = std::make_shared<Notices>();
  transport_ = std::make_unique<Transport>(settings_.address, settings_.partition);
  subscribe(robot);
  sender_ = std::make_unique<Sender>(robot, settings_, *transport_, joints_, notices_);
  const std::string first_joint = robot.joints.empty() ? "" : robot.joints.front().name;
  awaitState(first_joint);
  watch_ = std::make_unique<Watch>(*transport_, settings_, first_joint, joints_, world_, notices_);
}

// What the transport calls lives as long as a call may last, also behind close().
void GazeboHal::subscribe(const config::RobotDescription& robot) {
  const Topics topics(settings_);
  joints_ = std::make_shared<JointInbox>(namesOf(robot), topics.of(settings_.topics.joint_state), settings_.timeout_ns,
                                         notices_);
  world_ = std::make_shared<WorldInbox>(settings_.world, notices_);
  for (const config::SensorDescription& imu : robot.imus)
    imus_.push_back(std::make_shared<SensorInbox<link::ImuState>>(imu.name, topics.ofSensor(settings_.topics.imu, imu),
                                                                  kImu, readImu, notices_));
  for (const config::SensorDescription& sensor : robot.force_torques)
    force_torques_.push_back(std::make_shared<SensorInbox<link::ForceTorqueState>>(
        sensor.name, topics.ofSensor(settings_.topics.force_torque, sensor), kWrench, readWrench, notices_));
  const auto hear = [this](const std::string& topic, const auto& inbox) {
    transport_->subscribe(topic, [inbox](std::string_view type, Bytes message) { inbox->hear(type, message); });
  };
  hear(joints_->topic(), joints_);
  hear(topics.of(settings_.topics.statistics), world_);
  for (const auto& imu : imus_) hear(imu->topic(), imu);
  for (const auto& sensor : force_torques_) hear(sensor->topic(), sensor);
}

void GazeboHal::awaitState(const std::string& first_joint) {
  const FirstState first = joints_->awaitFirst(kGreeting);
  if (first.is_there) return;
  const std::string why = whyNoState(first, settings_, joints_->topic(), first_joint, *transport_);
  sender_.reset();
  transport_.reset();
  throw std::runtime_error(why);
}

void GazeboHal::measure(Measurements& into) noexcept {
  for (std::size_t i = 0; i < into.joints.size(); ++i) {
    link::JointState& joint = into.joints[i];
    joint.link_position = joint.motor_position = sample_.joints[i].position;
    joint.link_velocity = joint.motor_velocity = sample_.joints[i].velocity;
    joint.effort = sample_.joints[i].effort;
    joint.temperature_motor = joint.temperature_driver = std::numeric_limits<float>::quiet_NaN();
    joint.fault = 0;
  }
}

// Nothing of what was measured before a reset may lead to a motion behind it: some cycles without success make all
// joints safe, and let references begin where the joints are.
Status GazeboHal::status(Measurements& into) noexcept {
  if (sample_.era != era_) {
    era_ = sample_.era;
    resting_ = cycles_after_reset_;
  }
  const int unsound = joints_->unsoundJoint();
  if (unsound >= 0) {
    if (static_cast<std::size_t>(unsound) < into.joints.size())
      into.joints[static_cast<std::size_t>(unsound)].fault = 1;
    return Status::kFault;
  }
  const bool is_paused = world_->pausedNs() > sample_.heard_ns;
  const bool is_silent = link::now() - sample_.heard_ns > settings_.timeout_ns;
  if (is_paused || is_silent || resting_ > 0) {
    resting_ = std::max(0, resting_ - 1);
    return Status::kTimeout;
  }
  return Status::kOk;
}

Status GazeboHal::sense(Measurements& into) noexcept {
  if (joints_->sample(sample_, last_sample_) == link::Read::kNew || status_ == Status::kFault) measure(into);
  measureRest(into);
  for (std::size_t i = 0; i < imus_.size() && i < into.imus.size(); ++i) imus_[i]->read(into.imus[i]);
  for (std::size_t i = 0; i < force_torques_.size() && i < into.force_torques.size(); ++i)
    force_torques_[i]->read(into.force_torques[i]);
  status_ = status(into);
  return status_;
}

Status GazeboHal::move(std::span<const Reference> references) noexcept {
  sender_->leave(references, status_ == Status::kOk);
  return status_;
}

std::vector<std::string> GazeboHal::news() {
  if (!watch_) return {};
  watch_->look();
  for (const auto& imu : imus_) watch_->lookAt(*imu);
  for (const auto& sensor : force_torques_) watch_->lookAt(*sensor);
  return notices_->take();
}

void GazeboHal::end() {
  const bool is_there = status_ == Status::kOk;
  sender_->stop();
  if (settings_.at_end == AtEnd::kLeave || !is_there) return;
  sender_->hold();
  if (settings_.at_end == AtEnd::kPause)
    transport_->pauseWorld(Topics(settings_).of(settings_.topics.control), kControlMs);
  std::this_thread::sleep_for(kTimeToLeave);
}

void GazeboHal::close() noexcept {
  if (!transport_) return;
  try {
    end();
  } catch (const std::exception&) {
    // The robot is left as it is: there is nobody more to tell.
  }
  watch_.reset();
  sender_.reset();
  transport_.reset();
}

}  // namespace robotui::rt::hal::gazebo
