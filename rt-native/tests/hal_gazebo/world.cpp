#include "world.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <thread>

#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/world_stats.pb.h>
#include <ignition/msgs/wrench.pb.h>

namespace robotui::rt::hal::gazebo {

namespace {

namespace im = ignition::msgs;

constexpr double kStep = 0.001;         // s of simulated time
constexpr double kPositionTime = 0.03;  // s, of the first order
constexpr double kVelocityTime = 0.02;  // s
constexpr double kInertia = 0.5;        // kg m^2
constexpr double kFriction = 2.0;       // N m s/rad
constexpr double kMostSpeed = 6.0;      // rad/s
constexpr int kStateEvery = 2;          // ms
constexpr int kSensorsEvery = 10;       // ms
constexpr int kStatisticsEvery = 50;    // ms

ignition::transport::NodeOptions in(const std::string& partition) {
  ignition::transport::NodeOptions options;
  options.SetPartition(partition);
  return options;
}

void setTime(im::Time& time, long ms) {
  time.set_sec(ms / 1000);
  time.set_nsec(static_cast<std::int32_t>(ms % 1000 * 1'000'000));
}

void move(WorldJoint& joint) {
  if (joint.way == 'p')
    joint.velocity = std::clamp((joint.wanted - joint.position) / kPositionTime, -kMostSpeed, kMostSpeed);
  if (joint.way == 'v') joint.velocity += (joint.wanted - joint.velocity) * kStep / kVelocityTime;
  if (joint.way == 'e') joint.velocity += (joint.wanted - kFriction * joint.velocity) / kInertia * kStep;
  joint.position += joint.velocity * kStep;
  joint.effort = joint.way == 'e' ? joint.wanted : kFriction * joint.velocity;
}

}  // namespace

World::World(const WorldOptions& options) : options_(options), node_(in(options.partition)), paused_(options.paused) {
  const std::string topic = "/world/" + options.world + "/model/" + options.model + "/joint_state";
  state_ = options.strange ? node_.Advertise<im::Double>(topic) : node_.Advertise<im::Model>(topic);
  if (!options.strange) advertise();
}

void World::advertise() {
  const std::string world = "/world/" + options_.world;
  statistics_ = node_.Advertise<im::WorldStatistics>(world + "/stats");
  clock_ = node_.Advertise<im::Clock>(world + "/clock");
  if (!options_.imu.empty()) imu_ = node_.Advertise<im::IMU>(options_.imu);
  if (!options_.force_torque.empty()) force_torque_ = node_.Advertise<im::Wrench>(options_.force_torque);
  for (const std::string& name : options_.joints) subscribe(joints_[name] = WorldJoint{.name = name});
  const std::function<bool(const im::WorldControl&, im::Boolean&)> serve = [this](const im::WorldControl& request,
                                                                                  im::Boolean& reply) {
    reply.set_data(control(request));
    return true;
  };
  node_.Advertise(world + "/control", serve);
}

void World::subscribe(WorldJoint& joint) {
  const std::string base = "/model/" + options_.model + "/joint/" + joint.name;
  const std::pair<char, const char*> ways[] = {{'p', "/0/cmd_pos"}, {'v', "/cmd_vel"}, {'e', "/cmd_force"}};
  for (const auto& [way, topic] : ways) {
    if (options_.controllers.find(way) == std::string::npos) continue;
    std::function<void(const im::Double&)> take = [this, way = way, name = joint.name](const im::Double& wanted) {
      const std::lock_guard lock(mutex_);
      WorldJoint& told = joints_.at(name);
      told.way = way;
      told.wanted = wanted.data();
      ++told.told;
    };
    node_.Subscribe(base + topic, take);
  }
}

void World::step() {
  ++simulated_ms_;
  for (auto& [name, joint] : joints_) move(joint);
}

// As the simulator's publisher of joint states, it sends also while time stands.
void World::tick() {
  const std::lock_guard lock(mutex_);
  ++ticks_;
  if (options_.strange) {
    state_.Publish(im::Double());
    return;
  }
  for (owed_ += paused_ ? 0 : factor_; owed_ >= 1; --owed_) step();
  if (silent_) return;
  if (ticks_ % kStateEvery == 0) send();
  if (ticks_ % kSensorsEvery == 0) sendSensors();
  if (ticks_ % kStatisticsEvery == 0) sendStatistics();
}

im::Model World::state() const {
  im::Model model;
  setTime(*model.mutable_header()->mutable_stamp(), simulated_ms_);
  model.set_name(options_.model);
  for (const auto& [name, joint] : joints_) {
    if (name == lack_) continue;
    im::Joint& each = *model.add_joint();
    each.set_name(name);
    each.mutable_axis1()->set_position(name == nan_ ? std::numeric_limits<double>::quiet_NaN() : joint.position);
    each.mutable_axis1()->set_velocity(joint.velocity);
    each.mutable_axis1()->set_force(joint.effort);
  }
  return model;
}

// Late: every other state waits until a newer one was sent.
void World::send() {
  if (late_ && !kept_) {
    kept_ = state();
    return;
  }
  state_.Publish(state());
  if (kept_) state_.Publish(*std::exchange(kept_, {}));
}

void World::sendSensors() {
  im::IMU imu;
  imu.mutable_orientation()->set_z(std::sqrt(0.5));
  imu.mutable_orientation()->set_w(std::sqrt(0.5));
  imu.mutable_angular_velocity()->set_z(0.25);
  imu.mutable_linear_acceleration()->set_z(nan_ == "imu" ? std::numeric_limits<double>::quiet_NaN() : 9.5);
  if (imu_) imu_.Publish(imu);
  im::Wrench wrench;
  wrench.mutable_force()->set_x(1);
  wrench.mutable_force()->set_y(2);
  wrench.mutable_torque()->set_z(3);
  if (force_torque_) force_torque_.Publish(wrench);
}

void World::sendStatistics() {
  im::WorldStatistics statistics;
  setTime(*statistics.mutable_sim_time(), simulated_ms_);
  statistics.set_paused(paused_);
  statistics.set_real_time_factor(factor_);
  statistics_.Publish(statistics);
  im::Clock clock;
  setTime(*clock.mutable_sim(), simulated_ms_);
  clock_.Publish(clock);
}

bool World::control(const im::WorldControl& request) {
  const std::lock_guard lock(mutex_);
  paused_ = request.pause();
  if (request.has_reset() && request.reset().all()) reset();
  return true;
}

void World::reset() {
  simulated_ms_ = 0;
  for (auto& [name, joint] : joints_) joint = WorldJoint{.name = name, .told = joint.told};
}

std::string World::describe(const std::string& name) const {
  const WorldJoint& joint = joints_.at(name);
  std::ostringstream text;
  text << joint.way << ' ' << joint.wanted << ' ' << joint.position << ' ' << joint.told;
  return text.str();
}

std::string World::obey(const std::string& line) {
  const std::lock_guard lock(mutex_);
  std::istringstream words(line);
  std::string verb;
  std::string name;
  words >> verb >> name;
  if (verb == "joint") return describe(name);
  if (verb == "listeners") return state_.HasConnections() ? "some" : "none";
  if (verb == "paused") return paused_ ? "yes" : "no";
  if (verb == "pause" || verb == "run") paused_ = verb == "pause";
  if (verb == "silent" || verb == "speak") silent_ = verb == "silent";
  if (verb == "slow") factor_ = std::stod(name);
  if (verb == "nan" || verb == "sound") nan_ = name;
  if (verb == "lack" || verb == "sound") lack_ = name;
  if (verb == "late") late_ = true;
  if (verb == "reset") reset();
  if (verb == "garbage") state_.PublishRaw(std::string("\x0a\xff\xff\xff\xff\x07garbage", 13), "ignition.msgs.Model");
  return "done";
}

void runWorld(const WorldOptions& options, std::istream& input, std::ostream& output) {
  World world(options);
  const std::jthread clock([&world](const std::stop_token& stop) {
    auto next = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
      world.tick();
      next += std::chrono::milliseconds(1);
      std::this_thread::sleep_until(next);
    }
  });
  output << "ready" << std::endl;
  for (std::string line; std::getline(input, line);) output << world.obey(line) << std::endl;
}

}  // namespace robotui::rt::hal::gazebo
