#include "cartesian_motion.h"

#include <algorithm>
#include <cmath>

#include "chosen_joints.h"
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
  openReport(setup, *chain);
  return true;
}

// One task without a name: its commands name none.
void CartesianMotion::openReport(Setup& setup, const KinematicChain& chain) {
  for (const Moved& moved : joints_) addJoint(report_, moved.joint->index());
  report_.count = 1;
  TaskReport::Task& said = report_.tasks[0];
  assign(said.link, chain.tipLink());
  assign(said.base, chain.baseLink());
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
  at_ = tip();
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

Eigen::Isometry3d CartesianMotion::tip() const noexcept {
  Eigen::Isometry3d base;
  Eigen::Isometry3d tip;
  model_->getPose(base_, base);
  model_->getPose(tip_, tip);
  return base.inverse(Eigen::Isometry) * tip;
}

// Damped least squares over the joints that are not held; false where all are.
bool CartesianMotion::solve(const Twist& twist) noexcept {
  Eigen::Matrix<double, 6, 6> square = damping_ * damping_ * Eigen::Matrix<double, 6, 6>::Identity();
  bool any = false;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].held) continue;
    const Twist column = reduced_.col(static_cast<Eigen::Index>(i));
    square += column * column.transpose();
    any = true;
  }
  const Twist weighted = square.llt().solve(twist);
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
  const Twist along = path_.advance(poseDifference(at_, path_.now()), speeds_, period);
  const Twist twist = along + kGain * poseDifference(at_, path_.now());
  Eigen::Isometry3d base;
  model_->getPose(base_, base);
  model_->getJacobian(tip_, jacobian_);
  const Eigen::Matrix3d to_base = base.linear().transpose();
  const Eigen::Index offset = jacobian_.cols() - positions_.size();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Twist column = jacobian_.col(offset + joints_[i].in_model);
    reduced_.col(static_cast<Eigen::Index>(i)) << to_base * column.head<3>(), to_base * column.tail<3>();
    joints_[i].held = false;
  }
  bool held = false;
  while (solve(twist) && holdAtLimits(period)) held = true;
  limitVelocities();
  integrate(period);
  updateModel();
  at_ = tip();
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
