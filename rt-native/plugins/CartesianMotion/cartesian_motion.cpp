#include "cartesian_motion.h"

#include <algorithm>
#include <cmath>

#include "chosen_joints.h"
#include "held_position.h"
#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kGain = 10;         // 1/s, with which an error of the tip decays
constexpr double kFarLinear = 0.05;  // m behind the path from which on the path waits for the tip
constexpr double kFarAngular = 0.2;  // rad
constexpr double kThere = 1e-3;      // m and rad
constexpr double kMostMetres = 100;

Eigen::Matrix3d rotation(double roll, double pitch, double yaw) noexcept {
  return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

// The rotation vector from one orientation to another, in the axes of the base.
Eigen::Vector3d turn(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) noexcept {
  const Eigen::AngleAxisd between(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
  return between.angle() * between.axis();
}

Eigen::Matrix<double, 6, 1> difference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) noexcept {
  Eigen::Matrix<double, 6, 1> result;
  result << to.translation() - from.translation(), turn(from, to);
  return result;
}

double fraction(double length, double most) noexcept { return length > most ? most / length : 1; }

}  // namespace

bool CartesianMotion::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  params.knowsOnly({"chain", "linear_speed", "angular_speed", "damping", "pose"});
  linear_speed_ = params.realOr("linear_speed", linear_speed_, 1e-4, 10);
  angular_speed_ = params.realOr("angular_speed", angular_speed_, 1e-4, 20);
  damping_ = params.realOr("damping", damping_, 1e-4, 1);
  if (const auto pose = params.find("pose")) {
    for (const auto& item : pose->items("[0.4, 0, 0.5, 0, 1.57, 0]"))
      first_pose_.push_back(item.real(-kMostMetres, kMostMetres));
    if (first_pose_.size() != 3 && first_pose_.size() != 6)
      pose->fail("has " + std::to_string(first_pose_.size()) + " numbers; expected 3 or 6");
  }
  model_ = setup.createModel();
  positions_.setZero(model_->getJointNum());
  jacobian_.setZero(6, model_->getDofs());
  return findChain(setup);
}

bool CartesianMotion::findChain(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  const auto chains = setup.robot().chains();
  const auto named = params.find("chain");
  if (!named && chains.size() != 1) {
    setup.fail("The robot has " + std::to_string(chains.size()) + " chains: say with `chain` whose tip is to move.");
    return false;
  }
  KinematicChain* chain = named ? setup.robot().findChain(named->text()) : &chains.front();
  if (chain == nullptr) named->fail("is no chain of the SRDF");
  base_ = model_->findLink(chain->baseLink());
  tip_ = model_->findLink(chain->tipLink());
  std::vector<std::string> names;
  for (int i = 0; i < chain->size(); ++i) {
    Joint& joint = chain->joint(i);
    joints_.push_back({&joint, model_->findJoint(joint.name())->index(), 0, 0, false});
    names.push_back(joint.name());
  }
  reduced_.setZero(6, chain->size());
  setup.claim(names);
  return true;
}

RtStatus CartesianMotion::on_start(double /*time*/) noexcept {
  for (Moved& moved : joints_) {
    moved.position =
        std::clamp(heldPosition(*moved.joint), moved.joint->description().lower, moved.joint->description().upper);
  }
  updateModel();
  target_ = path_ = at_ = tip();
  if (!first_pose_.empty()) setTarget(first_pose_.data(), static_cast<int>(first_pose_.size()));
  return RtStatus::ok();
}

void CartesianMotion::updateModel() noexcept {
  for (const Moved& moved : joints_) positions_[moved.in_model] = moved.position;
  model_->setJointPosition(positions_);
  model_->update();
}

Eigen::Isometry3d CartesianMotion::tip() const noexcept {
  Eigen::Isometry3d base;
  Eigen::Isometry3d tip;
  model_->getPose(base_, base);
  model_->getPose(tip_, tip);
  return base.inverse(Eigen::Isometry) * tip;
}

// Moves the path on and says with which velocity; a tip that is far behind is waited for.
CartesianMotion::Vector6 CartesianMotion::advance(double period) noexcept {
  const Vector6 behind = difference(at_, path_);
  if (behind.head<3>().norm() > kFarLinear || behind.tail<3>().norm() > kFarAngular) return Vector6::Zero();
  const Eigen::Vector3d line = target_.translation() - path_.translation();
  const Eigen::Vector3d rest = turn(path_, target_);
  const double part =
      std::min(fraction(line.norm(), linear_speed_ * period), fraction(rest.norm(), angular_speed_ * period));
  const Eigen::Vector3d angle = part * rest;
  path_.translation() += part * line;
  if (angle.norm() > 0) {
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(angle.norm(), angle.normalized()) * path_.linear();
    path_.linear() = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  }
  Vector6 velocity;
  velocity << part * line / period, angle / period;
  return velocity;
}

// Damped least squares over the joints that are not held; false where all are.
bool CartesianMotion::solve(const Vector6& twist) noexcept {
  Eigen::Matrix<double, 6, 6> square = damping_ * damping_ * Eigen::Matrix<double, 6, 6>::Identity();
  bool any = false;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].held) continue;
    const Vector6 column = reduced_.col(static_cast<Eigen::Index>(i));
    square += column * column.transpose();
    any = true;
  }
  const Vector6 weighted = square.llt().solve(twist);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    joints_[i].velocity = joints_[i].held ? 0 : reduced_.col(static_cast<Eigen::Index>(i)).dot(weighted);
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
  const Vector6 along = advance(period);
  const Vector6 twist = along + kGain * difference(at_, path_);
  Eigen::Isometry3d base;
  model_->getPose(base_, base);
  model_->getJacobian(tip_, jacobian_);
  const Eigen::Matrix3d to_base = base.linear().transpose();
  const Eigen::Index offset = jacobian_.cols() - positions_.size();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Vector6 column = jacobian_.col(offset + joints_[i].in_model);
    reduced_.col(static_cast<Eigen::Index>(i)) << to_base * column.head<3>(), to_base * column.tail<3>();
    joints_[i].held = false;
  }
  bool held = false;
  while (solve(twist) && holdAtLimits(period)) held = true;
  limitVelocities();
  integrate(period);
  updateModel();
  at_ = tip();
  const bool there = difference(at_, target_).cwiseAbs().maxCoeff() < kThere;
  status_ = there ? "at the target" : held ? "a joint is at its limit" : "moving";
  return RtStatus::ok();
}

void CartesianMotion::on_stop(double /*time*/) noexcept { status_ = "stopped"; }

bool CartesianMotion::setTarget(const double* numbers, int count) noexcept {
  if (count != 3 && count != 6) return false;
  if (!std::all_of(numbers, numbers + count, [](double x) { return std::abs(x) <= kMostMetres; })) return false;
  target_.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  if (count == 6) target_.linear() = rotation(numbers[3], numbers[4], numbers[5]);
  return true;
}

bool CartesianMotion::moveTarget(const double* numbers, int count) noexcept {
  if (count != 3 && count != 6) return false;
  if (!std::all_of(numbers, numbers + count, [](double x) { return std::abs(x) <= kMostMetres; })) return false;
  target_.translation() += Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  if (count == 6) {
    const Eigen::Matrix3d turned = rotation(numbers[3], numbers[4], numbers[5]) * target_.linear();
    target_.linear() = turned;
  }
  return true;
}

bool CartesianMotion::on_command(std::string_view words) {
  double numbers[6] = {};
  if (words == "stop") {
    target_ = path_ = at_;
    return true;
  }
  if (words.starts_with("pose ")) return setTarget(numbers, readNumbers(words.substr(5), numbers, 6));
  if (words.starts_with("move ")) return moveTarget(numbers, readNumbers(words.substr(5), numbers, 6));
  return false;
}

}  // namespace robotui::rt::plugins
