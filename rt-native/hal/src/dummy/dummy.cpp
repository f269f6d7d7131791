#include "dummy.h"

#include <algorithm>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::hal {

namespace {

constexpr double kGravity = 9.80665;

double positionIn(const std::vector<config::Posture>& postures, const std::string& posture, const std::string& joint) {
  for (const config::Posture& each : postures) {
    if (each.name != posture) continue;
    for (const auto& [name, position] : each.joints) {
      if (name == joint) return position;
    }
  }
  return 0;
}

void checkPosture(const std::vector<config::Posture>& postures, const std::string& posture,
                  const config::Place& place) {
  const bool there =
      std::any_of(postures.begin(), postures.end(), [&](const config::Posture& each) { return each.name == posture; });
  if (there || posture.empty()) return;
  const std::string known = link::listed(postures, &config::Posture::name, "none");
  throw config::ConfigError(place, "The SRDF has no posture '" + posture + "'; it has: " + known + ".");
}

}  // namespace

std::vector<JointMotion> motionsOf(const config::RobotDescription& robot, const std::string& posture,
                                   const config::Place& place) {
  checkPosture(robot.postures, posture, place);
  std::vector<JointMotion> motions;
  for (const config::JointDescription& joint : robot.joints)
    motions.emplace_back(joint, positionIn(robot.postures, posture, joint.name));
  return motions;
}

void measureRest(Measurements& into) noexcept {
  for (link::ImuState& imu : into.imus) imu = {{0, 0, 0, 1}, {0, 0, 0}, {0, 0, kGravity}};
  std::fill(into.force_torques.begin(), into.force_torques.end(), link::ForceTorqueState{});
}

void Dummy::open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) {
  const config::Reader params(config.params, config.place.file, "HALInterface.params", config.place);
  params.knowsOnly({"posture"});
  joints_ = motionsOf(robot, params.textOr("posture", ""), config.place);
  period_s_ = static_cast<double>(period_ns) * 1e-9;
}

Status Dummy::sense(Measurements& into) noexcept {
  for (std::size_t j = 0; j < joints_.size() && j < into.joints.size(); ++j) joints_[j].measure(into.joints[j]);
  measureRest(into);
  return Status::kOk;
}

Status Dummy::move(std::span<const Reference> references) noexcept {
  for (std::size_t j = 0; j < joints_.size() && j < references.size(); ++j) joints_[j].step(references[j], period_s_);
  return Status::kOk;
}

}  // namespace robotui::rt::hal
