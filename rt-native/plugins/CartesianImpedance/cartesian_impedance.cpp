#include "cartesian_impedance.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kMostStiffness = 1e5;
constexpr double kMostDamping = 1e4;
constexpr double kSingular = 0.02;  // below that the tip hardly feels what a joint does
constexpr const char* kExample = "[500, 500, 500, 30, 30, 30]";

Twist axesOr(const config::Reader& params, const char* key, const Twist& otherwise, double most) {
  const auto found = params.find(key);
  if (!found) return otherwise;
  const auto items = found->items(kExample);
  if (items.size() != 6)
    found->fail("has " + std::to_string(items.size()) + " numbers; expected 6, such as " + kExample);
  Twist axes;
  for (Eigen::Index i = 0; i < 6; ++i) axes[i] = items[static_cast<std::size_t>(i)].real(0, most);
  return axes;
}

// So that the status changes when something happens, and not with every sample.
std::string_view centi(double value, std::array<char, 32>& room) noexcept {
  const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::fixed, 2);
  return error == std::errc() ? std::string_view(room.data(), static_cast<std::size_t>(end - room.data())) : "?";
}

}  // namespace

bool CartesianImpedance::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  params.knowsOnly({"chain", "stiffness", "damping", "axes", "posture_damping", "effort", "ramp", "linear_speed",
                    "angular_speed", "tolerance"});
  goal_ = axesOr(params, "stiffness", goal_, kMostStiffness);
  damping_ = axesOr(params, "damping", damping_, kMostDamping);
  const auto axes = params.find("axes");
  in_axes_of_tip_ = axes && axes->oneOf({"base", "tip"}) == "tip";
  posture_damping_ = params.realOr("posture_damping", posture_damping_, 0, kMostDamping);
  effort_ = params.realOr("effort", effort_, 0.01, 1);
  ramp_ = params.realOr("ramp", ramp_, 0, 60);
  speeds_.linear = params.realOr("linear_speed", speeds_.linear, 1e-4, 10);
  speeds_.angular = params.realOr("angular_speed", speeds_.angular, 1e-4, 20);
  if (const auto tolerance = params.find("tolerance")) {
    const auto items = tolerance->items("[0.01, 0.05]");
    if (items.size() != 2) tolerance->fail("needs two numbers, of m and rad, such as [0.01, 0.05]");
    linear_tolerance_ = items[0].real(1e-4, 1);
    angular_tolerance_ = items[1].real(1e-4, 3);
  }
  robot_ = &setup.robot();
  gravity_.emplace(setup);
  if (!chain_.find(setup, params, gravity_->model())) return false;
  velocities_.setZero(static_cast<Eigen::Index>(chain_.joints().size()));
  efforts_.setZero(velocities_.size());
  return true;
}

RtStatus CartesianImpedance::on_start(double /*time*/) noexcept {
  gravity_->update(*robot_);
  path_.rest(chain_.tip(gravity_->model()));
  stiffness_ = goal_;
  return RtStatus::ok();
}

// A stiffness that is changed comes slowly: the arm must not jump where it is held away from its pose.
void CartesianImpedance::approachGoal(double period) noexcept {
  const double part = ramp_ > 0 ? std::min(1.0, period / ramp_) : 1;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double step = std::max(goal_[i], stiffness_[i]) * part;
    stiffness_[i] = std::clamp(goal_[i], stiffness_[i] - step, stiffness_[i] + step);
  }
}

Twist CartesianImpedance::wrench(const Twist& error, const Twist& slower, const Eigen::Matrix3d& tip) const noexcept {
  if (!in_axes_of_tip_) return stiffness_.cwiseProduct(error) + damping_.cwiseProduct(slower);
  const auto turned = [&](const Eigen::Matrix3d& by, const Twist& twist) {
    Twist result;
    result << by * twist.head<3>(), by * twist.tail<3>();
    return result;
  };
  const Eigen::Matrix3d to_tip = tip.transpose();
  return turned(tip, stiffness_.cwiseProduct(turned(to_tip, error)) + damping_.cwiseProduct(turned(to_tip, slower)));
}

// What of the joints' motion the tip does not feel.
void CartesianImpedance::dampPosture(const ChainFrame::Jacobian& jacobian, const Twist& velocity) noexcept {
  Eigen::Matrix<double, 6, 6> square = kSingular * kSingular * Eigen::Matrix<double, 6, 6>::Identity();
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i) square += jacobian.col(i) * jacobian.col(i).transpose();
  const Twist felt = square.llt().solve(velocity);
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
    efforts_[i] -= posture_damping_ * (velocities_[i] - jacobian.col(i).dot(felt));
}

// All joints give the same part of what the spring wants, so that it goes on to point to the pose.
double CartesianImpedance::share(const Eigen::VectorXd& weight) const noexcept {
  double part = 1;
  for (std::size_t i = 0; i < chain_.joints().size(); ++i) {
    const Joint& joint = *chain_.joints()[i];
    const double wanted = efforts_[static_cast<Eigen::Index>(i)];
    const double most = effort_ * joint.description().effort;
    const double room = std::max(0.0, wanted > 0 ? most - weight[joint.index()] : most + weight[joint.index()]);
    if (std::abs(wanted) > room) part = std::min(part, room / std::abs(wanted));
  }
  return part;
}

RtStatus CartesianImpedance::control_loop(double /*time*/, double period) noexcept {
  approachGoal(period);
  const Eigen::VectorXd& weight = gravity_->update(*robot_);
  const ChainFrame::Jacobian& jacobian = chain_.jacobian(gravity_->model());
  const Eigen::Isometry3d tip = chain_.tip(gravity_->model());
  Twist velocity = Twist::Zero();
  for (std::size_t i = 0; i < chain_.joints().size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    velocities_[at] = chain_.joints()[i]->getJointVelocity();
    velocity += jacobian.col(at) * velocities_[at];
  }
  const Twist along = path_.advance(poseDifference(tip, path_.now()), speeds_, period);
  const Twist error = poseDifference(tip, path_.now());
  const Twist force = wrench(error, along - velocity, tip.linear());
  for (Eigen::Index i = 0; i < efforts_.size(); ++i) efforts_[i] = jacobian.col(i).dot(force);
  dampPosture(jacobian, velocity);
  const double part = share(weight);
  for (std::size_t i = 0; i < chain_.joints().size(); ++i) {
    Joint& joint = *chain_.joints()[i];
    joint.setEffortReference(weight[joint.index()] + part * efforts_[static_cast<Eigen::Index>(i)]);
  }
  say(error, poseDifference(path_.now(), path_.target()), part < 1);
  return RtStatus::ok();
}

void CartesianImpedance::say(const Twist& error, const Twist& rest, bool is_limited) noexcept {
  const double metres = error.head<3>().norm();
  const double radians = error.tail<3>().norm();
  std::array<char, 32> room{};
  if (metres > linear_tolerance_ || radians > angular_tolerance_) {
    status_.assign("gives way by ").append(centi(metres, room)).append(" m and ").append(centi(radians, room));
    status_.append(" rad");
  } else {
    status_.assign(rest.head<3>().norm() > linear_tolerance_ || rest.tail<3>().norm() > angular_tolerance_
                       ? "moving"
                       : "at the target");
  }
  if (is_limited) status_.append(", with the most effort that it may use");
}

void CartesianImpedance::on_stop(double /*time*/) noexcept { status_.assign("stopped"); }

bool CartesianImpedance::on_command(std::string_view words) {
  const std::string_view verb = takeWord(words);
  std::array<double, 6> numbers{};
  const int count = readNumbers(words, numbers.data(), 6);
  if (verb == "stop" && count == 0) {
    path_.rest(chain_.tip(gravity_->model()));
    return true;
  }
  if (verb == "pose") return path_.setTarget(numbers.data(), count);
  if (verb == "move") return path_.moveTarget(numbers.data(), count);
  const bool is_stiffness = verb == "stiffness";
  const double most = is_stiffness ? kMostStiffness : kMostDamping;
  const bool are_allowed =
      count == 6 && std::all_of(numbers.begin(), numbers.end(), [&](double each) { return each >= 0 && each <= most; });
  if ((!is_stiffness && verb != "damping") || !are_allowed) return false;
  (is_stiffness ? goal_ : damping_) = Eigen::Map<const Twist>(numbers.data());
  return true;
}

}  // namespace robotui::rt::plugins
