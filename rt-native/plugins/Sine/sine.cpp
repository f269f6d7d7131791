#include "sine.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "chosen_joints.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kGrowSeconds = 2.0;
constexpr double kMostFrequency = 5.0;  // Hz
constexpr double kOfTheLimit = 0.8;     // of the velocity
constexpr double kMargin = 0.01;        // rad or m, from the limits of position

}  // namespace

bool Sine::init_control_plugin(Setup& setup) {
  const YAML::Node& params = setup.params();
  amplitude_ = params["amplitude"].as<double>(amplitude_);
  frequency_ = params["frequency"].as<double>(frequency_);
  if (!(amplitude_ >= 0) || !(frequency_ > 0 && frequency_ <= kMostFrequency)) {
    setup.fail("`amplitude` must not be negative, and `frequency` above 0 and up to 5 Hz.");
    return false;
  }
  const auto joints = chosenJoints(config::Reader(params, {}, setup.name()), setup.robot());
  for (Joint* joint : joints) {
    swings_.push_back({joint, 0, 0});
  }
  setup.claim(namesOf(joints));
  return true;
}

RtStatus Sine::on_start(double /*time*/) noexcept {
  phase_ = 0;
  grown_ = 0;
  for (Swing& swing : swings_) {
    const auto& limits = swing.joint->description();
    swing.centre = std::clamp(swing.joint->getJointPosition(), limits.lower, limits.upper);
    limit(swing);
  }
  return RtStatus::ok();
}

// A joint at its limit does not swing: there is no room on one side.
void Sine::limit(Swing& swing) const noexcept {
  const auto& limits = swing.joint->description();
  const double room = std::min(limits.upper - swing.centre, swing.centre - limits.lower) - kMargin;
  const double quick =
      limits.velocity > 0 ? kOfTheLimit * limits.velocity / (2 * std::numbers::pi * frequency_) : amplitude_;
  swing.amplitude = std::max(0.0, std::min({amplitude_, room, quick}));
}

RtStatus Sine::control_loop(double /*time*/, double period) noexcept {
  phase_ = std::fmod(phase_ + 2 * std::numbers::pi * frequency_ * period, 2 * std::numbers::pi);
  grown_ = std::min(1.0, grown_ + period / kGrowSeconds);
  const double now = grown_ * std::sin(phase_);
  for (const Swing& swing : swings_) {
    swing.joint->setPositionReference(swing.centre + swing.amplitude * now);
  }
  return RtStatus::ok();
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
