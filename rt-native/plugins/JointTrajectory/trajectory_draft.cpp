#include "trajectory_draft.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kLongest = 3600;     // s
constexpr double kRounding = 1.0001;  // of a velocity limit
constexpr double kUnlimited = 1e9;

constexpr std::array<std::string_view, 3> kKinds{"positions", "velocities", "accelerations"};

double& valueOf(Knot& knot, Given kind) noexcept {
  switch (kind) {
    case Given::kPositions: return knot.position;
    case Given::kVelocities: return knot.velocity;
    case Given::kAccelerations: break;
  }
  return knot.acceleration;
}

std::size_t indexOf(Given kind) noexcept { return static_cast<std::size_t>(kind); }

}  // namespace

TrajectoryDraft::TrajectoryDraft(std::span<Joint* const> joints, const Tolerances& defaults)
    : robot_(joints), defaults_(defaults), tolerances_(joints.size()), path_(joints.size()) {}

void TrajectoryDraft::add(double number) noexcept {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 4);
  why_.append({text.data(), static_cast<std::size_t>(end - text.data())});
}

void TrajectoryDraft::add(std::size_t number) noexcept {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  why_.append({text.data(), static_cast<std::size_t>(end - text.data())});
}

void TrajectoryDraft::begin() noexcept {
  path_.clear();
  std::fill(tolerances_.begin(), tolerances_.end(), defaults_.joint);
  goal_time_ = defaults_.goal_time;
  speed_ = 1;
  velocity_ = 0;
  given_ = Given::kPositions;
  said_ = {};
  checked_ = 0;
  fastest_ = 0;
  is_open_ = true;
  why_.assign({});
}

bool TrajectoryDraft::addJoint(std::string_view name) noexcept {
  if (path_.points() > 0) return refuse("joints are to be named before the first point");
  const auto found =
      std::find_if(robot_.begin(), robot_.end(), [&](const Joint* joint) { return joint->name() == name; });
  if (found == robot_.end()) return refuse("'", name, "' is no joint of this plugin");
  if (!path_.addJoint(static_cast<std::size_t>(found - robot_.begin()))) return refuse("'", name, "' is named twice");
  return true;
}

bool TrajectoryDraft::addPoint(double seconds) noexcept {
  if (path_.joints().empty()) return refuse("there is a point before any joint is named");
  if (path_.points() > 0 && !endPoint()) return false;
  const std::size_t point = path_.points();
  if (!(seconds >= 0 && seconds <= kLongest))
    return refuse("point ", point + 1, " is at ", seconds, " s: expected 0 to ", kLongest);
  if (point > 0 && !(seconds > path_.time(point - 1)))
    return refuse("point ", point + 1, " is at ", seconds, " s, and the one before it at ", path_.time(point - 1),
                  " s: times must rise");
  if (!path_.addPoint(seconds)) return refuse("there are more than ", JointPath::kMostPoints, " points");
  said_ = {};
  return true;
}

bool TrajectoryDraft::addValues(Given kind, std::span<const double> values) noexcept {
  if (path_.points() == 0) return refuse(kKinds[indexOf(kind)], " are said before any point");
  const std::size_t point = path_.points() - 1;
  for (const double value : values) {
    std::size_t& place = said_[indexOf(kind)];
    if (place == path_.joints().size())
      return refuse("point ", point + 1, " has more ", kKinds[indexOf(kind)], " than joints (", path_.joints().size(),
                    ")");
    if (!std::isfinite(value)) return refuse("point ", point + 1, " has what is no number for ", name(place));
    if (kind == Given::kPositions && !isWithinLimits(place, value)) return false;
    valueOf(path_.knot(point, place), kind) = value;
    ++place;
  }
  return true;
}

bool TrajectoryDraft::isWithinLimits(std::size_t place, double position) noexcept {
  const Bounds limits = bounds(place);
  if (position >= limits.lower && position <= limits.upper) return true;
  return refuse("point ", path_.points(), " has ", name(place), " at ", position, ", beyond its limits, ", limits.lower,
                " and ", limits.upper);
}

// All joints have a position, and what one point says beyond that, all of them say.
bool TrajectoryDraft::endPoint() noexcept {
  const std::size_t joints = path_.joints().size();
  const std::size_t point = path_.points();
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    if (said_[kind] != joints && (said_[kind] != 0 || kind == 0))
      return refuse("point ", point, " has ", said_[kind], " ", kKinds[kind], " for ", joints, " joints");
  }
  const Given given = said_[2] > 0 ? Given::kAccelerations : said_[1] > 0 ? Given::kVelocities : Given::kPositions;
  if (given == Given::kAccelerations && said_[1] == 0)
    return refuse("point ", point, " has accelerations, but no velocities");
  if (point > 1 && given != given_)
    return refuse("point ", point,
                  " has other values than the first one: all must have velocities, or accelerations, or none");
  given_ = given;
  return true;
}

bool TrajectoryDraft::setSpeed(double factor) noexcept {
  if (!(factor > 0 && factor <= 1)) return refuse("the speed is ", factor, ": expected above 0 and up to 1");
  speed_ = factor;
  return true;
}

bool TrajectoryDraft::setVelocity(double fraction) noexcept {
  if (!(fraction > 0 && fraction <= 1))
    return refuse("the velocity is ", fraction, " of the limits: expected above 0 and up to 1");
  velocity_ = fraction;
  return true;
}

bool TrajectoryDraft::allow(double Tolerance::*which, double tolerance, std::string_view names) noexcept {
  if (!(tolerance >= 0)) return refuse("a tolerance is below zero: 0 is none");
  if (names.empty()) {
    for (Tolerance& each : tolerances_) each.*which = tolerance;
  }
  for (std::string_view name = takeWord(names); !name.empty(); name = takeWord(names)) {
    const std::size_t place = placeOf(name);
    if (place == path_.joints().size()) return refuse("a tolerance is said of '", name, "', which is not named before");
    tolerances_[place].*which = tolerance;
  }
  return true;
}

bool TrajectoryDraft::setGoalTime(double seconds) noexcept {
  goal_time_ = seconds;
  return seconds >= 0 || refuse("the patience is below zero");
}

// The number of joints where it is none of them.
std::size_t TrajectoryDraft::placeOf(std::string_view name) const noexcept {
  std::size_t place = 0;
  while (place < path_.joints().size() && this->name(place) != name) ++place;
  return place;
}

bool TrajectoryDraft::end() noexcept {
  if (path_.points() == 0) return refuse("there is no point");
  if (!endPoint()) return false;
  path_.complete(given_);
  path_.stretch(1 / speed_);
  checked_ = 1;
  is_open_ = false;
  return true;
}

TrajectoryDraft::Checked TrajectoryDraft::check() noexcept {
  if (checked_ < path_.points())
    return isBearable(checked_++, velocity_ > 0 ? kUnlimited : 1) ? Checked::kGoesOn : Checked::kRefused;
  if (velocity_ > 0 && fastest_ > velocity_) path_.stretch(fastest_ / velocity_);
  fastest_ = 0;
  return Checked::kGood;
}

// With `velocity` the first point may come later, and all behind it with it: by as much as it needs, in a few tries,
// since how fast the joint is now does not become less.
bool TrajectoryDraft::checkStart() noexcept {
  constexpr int kTries = 20;
  for (int i = 0; velocity_ > 0 && i < kTries; ++i) {
    fastest_ = 0;
    if (!isBearable(0, kUnlimited)) return false;
    if (fastest_ <= velocity_) return true;
    path_.stretch(std::clamp(fastest_ / velocity_, 1.01, 10.0));
  }
  return isBearable(0, 1);
}

bool TrajectoryDraft::isBearable(std::size_t point, double most) noexcept {
  for (std::size_t place = 0; place < path_.joints().size(); ++place) {
    const JointPath::Need need = path_.need(point, place, bounds(place));
    fastest_ = std::max(fastest_, need.velocity);
    if (need.leaves && point > 0)
      return refuse("between the points ", point, " and ", point + 1, " ", name(place), " would leave its limits");
    if (need.velocity > most * kRounding)
      return refuse("on the way to point ", point + 1, " ", name(place), " would need ", need.velocity,
                    " times its velocity limit: give it more time, or say `velocity`");
  }
  return true;
}

std::string_view TrajectoryDraft::name(std::size_t place) const noexcept {
  return robot_[path_.joints()[place]]->name();
}

Bounds TrajectoryDraft::bounds(std::size_t place) const noexcept {
  const config::JointDescription& joint = robot_[path_.joints()[place]]->description();
  return {joint.lower, joint.upper, joint.velocity > 0 ? joint.velocity : kUnlimited};
}

}  // namespace robotui::rt::plugins
