#include "cartesian_motion.h"

#include <algorithm>
#include <cmath>

#include "held_position.h"
#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kGain = 10;     // 1/s, with which an error of the tip decays
constexpr double kThere = 1e-3;  // m and rad
constexpr double kMostMetres = 100;

double fraction(double length, double most) noexcept { return length > most ? most / length : 1; }

}  // namespace

bool CartesianMotion::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  params.knowsOnly({"chain", "linear_speed", "angular_speed", "damping", "pose"});
  speeds_.linear = params.realOr("linear_speed", speeds_.linear, 1e-4, 10);
  speeds_.angular = params.realOr("angular_speed", speeds_.angular, 1e-4, 20);
  damping_ = params.realOr("damping", damping_, 1e-4, 1);
  if (const auto pose = params.find("pose")) {
    for (const auto& item : pose->items("[0.4, 0, 0.5, 0, 1.57, 0]"))
      first_pose_.push_back(item.real(-kMostMetres, kMostMetres));
    if (first_pose_.size() != 3 && first_pose_.size() != 6)
      pose->fail("has " + std::to_string(first_pose_.size()) + " numbers; expected 3 or 6");
  }
  model_ = setup.createModel();
  positions_.setZero(model_->getJointNum());
  if (!chain_.find(setup, params, *model_)) return false;
  for (std::size_t i = 0; i < chain_.joints().size(); ++i)
    joints_.push_back({chain_.joints()[i], chain_.inModel(i), 0, 0, false});
  openReport(setup);
  return true;
}

// One task without a name: its commands name none.
void CartesianMotion::openReport(Setup& setup) {
  for (const Moved& moved : joints_) addJoint(report_, moved.joint->index());
  report_.count = 1;
  TaskReport::Task& said = report_.tasks[0];
  assign(said.link, chain_.tipLink());
  assign(said.base, chain_.baseLink());
  said.linear = speeds_.linear;
  said.angular = speeds_.angular;
  said.priority = 1;
  said.mask = 0b111111;
  said.phase = TaskPhase::kThere;
  reports_ = ChannelWriter<TaskReport>(setup.channels(), taskChannel(setup.name()), kTaskDepth);
  reports_.write(report_);
}

void CartesianMotion::report() noexcept {
  report_.tasks[0].phase = isThere() ? TaskPhase::kThere : progress_.isStuck() ? TaskPhase::kStuck : TaskPhase::kMoving;
  reports_.write(report_);
}

RtStatus CartesianMotion::on_start(double /*time*/) noexcept {
  for (Moved& moved : joints_) {
    moved.position =
        std::clamp(heldPosition(*moved.joint), moved.joint->description().lower, moved.joint->description().upper);
  }
  updateModel();
  at_ = chain_.tip(*model_);
  path_.rest(at_);
  progress_.begin();
  if (!first_pose_.empty()) path_.setTarget(first_pose_.data(), static_cast<int>(first_pose_.size()));
  return RtStatus::ok();
}

void CartesianMotion::updateModel() noexcept {
  for (const Moved& moved : joints_) positions_[moved.in_model] = moved.position;
  model_->setJointPosition(positions_);
  model_->update();
}

// Damped least squares over the joints that are not held; false where all are.
bool CartesianMotion::solve(const Twist& twist) noexcept {
  Eigen::Matrix<double, 6, 6> square = damping_ * damping_ * Eigen::Matrix<double, 6, 6>::Identity();
  bool any = false;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].held) continue;
    const Twist column = jacobian_->col(static_cast<Eigen::Index>(i));
    square += column * column.transpose();
    any = true;
  }
  const Twist weighted = square.llt().solve(twist);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    joints_[i].velocity = joints_[i].held ? 0 : jacobian_->col(static_cast<Eigen::Index>(i)).dot(weighted);
  }
  return any;
}

// Joints that would leave their range stay, and the others do what they can; true where there was one.
bool CartesianMotion::holdAtLimits(double period) noexcept {
  bool any = false;
  for (Moved& moved : joints_) {
    const double next = moved.position + moved.velocity * period;
    const auto& limits = moved.joint->description();
    if (moved.held || (next >= limits.lower && next <= limits.upper)) continue;
    moved.held = any = true;
  }
  return any;
}

void CartesianMotion::limitVelocities() noexcept {
  double part = 1;
  for (const Moved& moved : joints_)
    part = std::min(part, fraction(std::abs(moved.velocity), moved.joint->description().velocity));
  for (Moved& moved : joints_) moved.velocity *= part;
}

void CartesianMotion::integrate(double period) noexcept {
  for (Moved& moved : joints_) {
    const auto& limits = moved.joint->description();
    moved.position = std::clamp(moved.position + moved.velocity * period, limits.lower, limits.upper);
    moved.joint->setPositionReference(moved.position);
  }
}

RtStatus CartesianMotion::control_loop(double /*time*/, double period) noexcept {
  const Twist along = path_.advance(poseDifference(at_, path_.now()), speeds_, period);
  const Twist twist = along + kGain * poseDifference(at_, path_.now());
  jacobian_ = &chain_.jacobian(*model_);
  for (Moved& moved : joints_) moved.held = false;
  bool held = false;
  while (solve(twist) && holdAtLimits(period)) held = true;
  limitVelocities();
  integrate(period);
  updateModel();
  at_ = chain_.tip(*model_);
  progress_.look(poseDifference(at_, path_.target()), speeds_, period);
  status_ = statusNow(held);
  report();
  return RtStatus::ok();
}

bool CartesianMotion::isThere() const noexcept {
  return poseDifference(at_, path_.target()).cwiseAbs().maxCoeff() < kThere;
}

std::string_view CartesianMotion::statusNow(bool is_held) const noexcept {
  if (isThere()) return "at the target";
  if (!progress_.isStuck()) return is_held ? "a joint is at its limit" : "moving";
  return is_held ? "it cannot go on: a joint is at its limit"
                 : "it cannot go on: it is at the end of its reach, or in a singular posture";
}

void CartesianMotion::on_stop(double /*time*/) noexcept { status_ = "stopped"; }

bool CartesianMotion::on_command(std::string_view words) {
  double numbers[6] = {};
  progress_.begin();
  if (words == "stop") {
    path_.stop(at_, speeds_);
    return true;
  }
  if (words.starts_with("pose ")) return path_.setTarget(numbers, readNumbers(words.substr(5), numbers, 6));
  if (words.starts_with("move ")) return path_.moveTarget(numbers, readNumbers(words.substr(5), numbers, 6));
  return false;
}

}  // namespace robotui::rt::plugins
