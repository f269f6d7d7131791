#include "homing.h"

#include <algorithm>
#include <cmath>

#include "minimum_jerk.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kPeakOfMean = 1.875;  // a minimum-jerk motion is this much faster in its middle than on average
constexpr double kUnlimited = 1.0;     // rad/s or m/s, for a joint whose limit is not known

std::vector<std::string> wantedJoints(const YAML::Node& params, const RobotInterface& robot) {
  std::vector<std::string> names;
  for (const auto& name : params["joints"]) {
    names.push_back(name.as<std::string>());
  }
  for (const auto& chosen : params["chains"]) {
    for (const auto& chain : robot.description().chains) {
      if (chain.name == chosen.as<std::string>()) {
        names.insert(names.end(), chain.joints.begin(), chain.joints.end());
      }
    }
  }
  return names;
}

}  // namespace

bool Homing::init_control_plugin(Setup& setup) {
  const YAML::Node& params = setup.params();
  const std::string posture = params["posture"].as<std::string>("home");
  speed_ = params["speed"].as<double>(speed_);
  least_seconds_ = params["time"].as<double>(0);
  if (!(speed_ > 0 && speed_ <= 1) || !(least_seconds_ >= 0)) {
    setup.fail("`speed` must be a fraction of the velocity limits, above 0 and up to 1, and `time` a number of seconds.");
    return false;
  }
  const auto wanted = wantedJoints(params, setup.robot());
  std::vector<std::string> moved;
  for (const config::Posture& there : setup.robot().description().postures) {
    for (const auto& [name, position] : there.joints) {
      const bool is_wanted = wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
      const bool is_new = std::find(moved.begin(), moved.end(), name) == moved.end();
      Joint* joint = there.name == posture && is_wanted && is_new ? setup.robot().findJoint(name) : nullptr;
      if (joint != nullptr) {
        ways_.push_back({joint, 0, std::clamp(position, joint->description().lower, joint->description().upper)});
        moved.push_back(name);
      }
    }
  }
  if (ways_.empty()) {
    setup.fail("The SRDF has no group_state '" + posture + "' for these joints: write one, or choose another with `posture`.");
    return false;
  }
  setup.claim(moved);
  return true;
}

// From where the references are: the joints do not jump, even where they do not quite follow.
void Homing::on_start(double time) {
  begun_ = time;
  seconds_ = least_seconds_;
  for (Way& way : ways_) {
    const double reference = way.joint->getPositionReference();
    const bool is_held = (way.joint->state().mode & link::kPosition) != 0 && std::isfinite(reference);
    way.from = is_held ? reference : way.joint->getJointPosition();
    const double limit = way.joint->description().velocity;
    const double speed = speed_ * (std::isfinite(limit) && limit > 0 ? limit : kUnlimited);
    seconds_ = std::max(seconds_, kPeakOfMean * std::abs(way.to - way.from) / speed);
  }
  status_ = "moving";
}

void Homing::control_loop(double time, double /*period*/) {
  const double done = seconds_ > 0 ? (time - begun_) / seconds_ : 1;
  for (const Way& way : ways_) {
    way.joint->setPositionReference(minimumJerk(way.from, way.to, done));
  }
  status_ = done < 1 ? "moving" : "at home";
}

}  // namespace robotui::rt::plugins

using robotui::rt::plugins::Homing;
ROBOTUI_RT_PLUGIN(Homing)
