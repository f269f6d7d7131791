#include "homing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "chosen_joints.h"
#include "held_position.h"
#include "minimum_jerk.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kPeakOfMean = 1.875;  // a minimum-jerk motion is this much faster in its middle than on average
constexpr double kUnlimited = 1.0;     // rad/s or m/s, for a joint whose limit is not known

}  // namespace

bool Homing::init_control_plugin(Setup& setup) {
  const YAML::Node& params = setup.params();
  const std::string posture = params["posture"].as<std::string>("home");
  speed_ = params["speed"].as<double>(speed_);
  least_seconds_ = params["time"].as<double>(0);
  tolerance_ = params["tolerance"].as<double>(tolerance_);
  if (!(speed_ > 0 && speed_ <= 1) || !(least_seconds_ >= 0) || !(tolerance_ > 0)) {
    setup.fail(
        "`speed` must be a fraction of the velocity limits, above 0 and up to 1, `time` a number of seconds, and "
        "`tolerance` above 0.");
    return false;
  }
  const auto wanted = chosenJoints(config::Reader(params, {}, setup.name()), setup.robot());
  std::vector<Joint*> moved;
  for (const config::Posture& there : setup.robot().description().postures) {
    for (const auto& [name, position] : there.joints) {
      Joint* joint = there.name == posture ? setup.robot().findJoint(name) : nullptr;
      const bool is_wanted = joint != nullptr && std::find(wanted.begin(), wanted.end(), joint) != wanted.end();
      if (is_wanted && std::find(moved.begin(), moved.end(), joint) == moved.end()) {
        moves_.push_back({joint, 0, std::clamp(position, joint->description().lower, joint->description().upper)});
        moved.push_back(joint);
      }
    }
  }
  if (moves_.empty()) {
    setup.fail("The SRDF has no group_state '" + posture +
               "' for these joints: write one, or choose another with `posture`.");
    return false;
  }
  setup.claim(namesOf(moved));
  return true;
}

RtStatus Homing::on_start(double time) noexcept {
  begun_ = time;
  seconds_ = least_seconds_;
  for (Move& move : moves_) {
    move.from = heldPosition(*move.joint);
    const double limit = move.joint->description().velocity;
    const double speed = speed_ * (std::isfinite(limit) && limit > 0 ? limit : kUnlimited);
    seconds_ = std::max(seconds_, kPeakOfMean * std::abs(move.to - move.from) / speed);
  }
  status_.assign("moving");
  return RtStatus::ok();
}

RtStatus Homing::control_loop(double time, double /*period*/) noexcept {
  const double done = seconds_ > 0 ? (time - begun_) / seconds_ : 1;
  for (const Move& move : moves_) {
    move.joint->setPositionReference(minimumJerk(move.from, move.to, done));
  }
  if (done < 1) {
    status_.assign("moving");
  } else {
    sayWhereItIs();
  }
  return RtStatus::ok();
}

// What was commanded is over; where the joints are is another matter.
void Homing::sayWhereItIs() noexcept {
  const Move* worst = &moves_.front();
  const auto away = [](const Move& move) { return std::abs(move.joint->getJointPosition() - move.to); };
  for (const Move& move : moves_) {
    if (away(move) > away(*worst)) worst = &move;
  }
  if (away(*worst) <= tolerance_) {
    status_.assign("at home");
    return;
  }
  std::array<char, 32> number{};
  const auto [end, error] =
      std::to_chars(number.data(), number.data() + number.size(), away(*worst), std::chars_format::fixed, 2);
  const std::string_view text =
      error == std::errc() ? std::string_view(number.data(), static_cast<std::size_t>(end - number.data())) : "far";
  status_.assign(worst->joint->description().name).append(" is ").append(text).append(" away from home");
}

}  // namespace robotui::rt::plugins

using robotui::rt::plugins::Homing;
ROBOTUI_RT_PLUGIN(Homing)
