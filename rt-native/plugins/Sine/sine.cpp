#include "sine.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace robotui::rt::plugins {
namespace {

constexpr double kGrowSeconds = 2.0;
constexpr double kMostFrequency = 5.0;   // Hz
constexpr double kOfTheLimit = 0.8;      // of the velocity
constexpr double kMargin = 0.01;         // rad or m, from the limits of position

}  // namespace

bool Sine::init_control_plugin(Setup& setup) {
  const YAML::Node& params = setup.params();
  amplitude_ = params["amplitude"].as<double>(amplitude_);
  frequency_ = params["frequency"].as<double>(frequency_);
  if (!(amplitude_ >= 0) || !(frequency_ > 0 && frequency_ <= kMostFrequency)) {
    setup.fail("`amplitude` must not be negative, and `frequency` above 0 and up to 5 Hz.");
    return false;
  }
  const auto& robot = setup.robot().description();
  std::vector<std::string> names;
  for (const auto& name : params["joints"]) {
    names.push_back(name.as<std::string>());
  }
  for (const auto& chosen : params["chains"]) {
    for (const auto& chain : robot.chains) {
      if (chain.name == chosen.as<std::string>()) {
        names.insert(names.end(), chain.joints.begin(), chain.joints.end());
      }
    }
  }
  for (const auto& joint : robot.joints) {
    if (names.empty() || std::find(names.begin(), names.end(), joint.name) != names.end()) {
      swings_.push_back({setup.robot().findJoint(joint.name), 0, 0});
    }
  }
  std::vector<std::string> claimed;
  for (const Swing& swing : swings_) {
    claimed.push_back(swing.joint->name());
  }
  setup.claim(claimed);
  return true;
}

void Sine::on_start(double /*time*/) {
  phase_ = 0;
  grown_ = 0;
  for (Swing& swing : swings_) {
    const auto& limits = swing.joint->description();
    swing.centre = std::clamp(swing.joint->getJointPosition(), limits.lower, limits.upper);
    limit(swing);
  }
}

// A joint at its limit does not swing: there is no room on one side.
void Sine::limit(Swing& swing) const noexcept {
  const auto& limits = swing.joint->description();
  const double room = std::min(limits.upper - swing.centre, swing.centre - limits.lower) - kMargin;
  const double quick = limits.velocity > 0 ? kOfTheLimit * limits.velocity / (2 * std::numbers::pi * frequency_) : amplitude_;
  swing.amplitude = std::max(0.0, std::min({amplitude_, room, quick}));
}

void Sine::control_loop(double /*time*/, double period) {
  phase_ = std::fmod(phase_ + 2 * std::numbers::pi * frequency_ * period, 2 * std::numbers::pi);
  grown_ = std::min(1.0, grown_ + period / kGrowSeconds);
  const double now = grown_ * std::sin(phase_);
  for (const Swing& swing : swings_) {
    swing.joint->setPositionReference(swing.centre + swing.amplitude * now);
  }
}

bool Sine::on_command(std::string_view words) {
  const std::size_t space = words.find(' ');
  const std::string_view what = words.substr(0, space);
  double value = 0;
  const std::string_view number = space == std::string_view::npos ? std::string_view() : words.substr(space + 1);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  const bool is_number = error == std::errc() && end == number.data() + number.size() && std::isfinite(value);
  if (is_number && what == "amplitude" && value >= 0) {
    amplitude_ = value;
  } else if (is_number && what == "frequency" && value > 0 && value <= kMostFrequency) {
    frequency_ = value;
  } else {
    return false;
  }
  grown_ = 0;
  for (Swing& swing : swings_) {
    limit(swing);
  }
  return true;
}

}  // namespace robotui::rt::plugins

using robotui::rt::plugins::Sine;
ROBOTUI_RT_PLUGIN(Sine)
