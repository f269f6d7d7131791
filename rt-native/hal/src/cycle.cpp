#include "cycle.h"

#include <algorithm>
#include <cmath>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::hal {

namespace {

link::Counts countsOf(const config::RobotDescription& robot) noexcept {
  return link::bounded({static_cast<std::uint32_t>(robot.joints.size()), static_cast<std::uint32_t>(robot.imus.size()),
                        static_cast<std::uint32_t>(robot.force_torques.size())});
}

}  // namespace

Cycle::Cycle(const config::RobotDescription& robot, const CycleSettings& settings, Hal& hal,
             const link::BoardSegment& board, CommandInbox& inbox, SafeTorque& torque, link::StateSegment& state)
    : settings_(settings), hal_(&hal), board_(board), inbox_(&inbox), torque_(&torque),
      writer_(state, countsOf(robot)) {
  const link::Counts counts = countsOf(robot);
  measured_ = {std::span(frame_.joints).first(counts.joints), std::span(frame_.imus).first(counts.imus),
               std::span(frame_.force_torques).first(counts.force_torques)};
  const double period_s = static_cast<double>(settings.period_ns) * 1e-9;
  for (std::uint32_t j = 0; j < counts.joints; ++j) joints_.emplace_back(robot.joints[j], period_s);
  references_.resize(counts.joints);
  torques_.resize(counts.joints);
  held_.resize(counts.joints);
  link::relaxedStore(writer_.loop().period_ns, settings.period_ns);
}

void Cycle::run(std::uint64_t cycle, std::int64_t start_ns) noexcept {
  inbox_->begin();
  sense();
  assign();
  publish(cycle);
  inbox_->collect(cycle,
                  start_ns + static_cast<std::int64_t>(settings_.deadline * static_cast<double>(settings_.period_ns)));
  link::relaxedStore(writer_.loop().missed_commands, inbox_->missed());
  apply();
  if (sensed_) move();
}

// Whoever measures: no plugin gets what is no number.
bool Cycle::areNumbers() noexcept {
  return std::all_of(measured_.joints.begin(), measured_.joints.end(), [](const link::JointState& joint) {
    return std::isfinite(joint.link_position) && std::isfinite(joint.motor_position) &&
           std::isfinite(joint.link_velocity) && std::isfinite(joint.motor_velocity) && std::isfinite(joint.effort);
  });
}

void Cycle::keepOld() noexcept {
  for (std::size_t j = 0; j < measured_.joints.size(); ++j) {
    link::JointState& now = measured_.joints[j];
    const link::JointState& old = last_good_.joints[j];
    now.link_position = old.link_position;
    now.motor_position = old.motor_position;
    now.link_velocity = old.link_velocity;
    now.motor_velocity = old.motor_velocity;
    now.effort = old.effort;
  }
}

// A robot that was away may have been moved: then all goes on from where it is.
void Cycle::sense() noexcept {
  Status status = hal_->sense(measured_);
  if (!areNumbers()) {
    keepOld();
    status = Status::kFault;
  }
  frame_.hal_status = static_cast<std::uint32_t>(status);
  frame_.sensed_ns = link::now();
  if (status != Status::kOk) {
    link::relaxedAdd<std::uint64_t>(writer_.loop().sense_failures, 1);
    silent_ = std::min(silent_ + 1, settings_.misses_before_safe);
    away_ = away_ || silent_ == settings_.misses_before_safe;
    return;
  }
  if (!sensed_ || away_) {
    for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].anchor(measured_.joints[j]);
  }
  sensed_ = true;
  away_ = false;
  silent_ = 0;
  std::copy(measured_.joints.begin(), measured_.joints.end(), last_good_.joints.begin());
}

// Grant before owner: see BoardReader.
void Cycle::assign() noexcept {
  const bool all_safe = away_ || ending_.load(std::memory_order_relaxed);
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    const std::uint32_t grant = board_.grant(j);
    const std::uint16_t owner = board_.owner(j);
    if (joints_[j].belongs(owner, grant, measured_.joints[j])) inbox_->forgive(owner);
    if (all_safe) joints_[j].makeSafe();
    if (owner != link::kNobody && !joints_[j].isSafe()) inbox_->want(owner);
  }
}

// With the references of the cycle before, which are what the measurements answer to.
void Cycle::publish(std::uint64_t cycle) noexcept {
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].describe(frame_.joints[j]);
  frame_.cycle = cycle;
  writer_.publish(frame_);
  writer_.ring();
}

bool Cycle::obey(std::uint32_t joint) noexcept {
  JointControl& control = joints_[joint];
  if (control.isSafe() || control.owner() == link::kNobody) return false;
  switch (inbox_->answer(control.owner())) {
    case Answer::kFresh: return control.command(inbox_->command(control.owner(), joint));
    case Answer::kMissed: return false;
    case Answer::kSafe: control.makeSafe(); return false;
  }
  return false;
}

void Cycle::apply() noexcept {
  bool torque_needed = false;
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    held_[j] = !obey(j);
    torque_needed |= held_[j] && joints_[j].holdsByEffort();
  }
  if (torque_needed) torque_->compute(measured_, torques_);
  holdRest();
}

double Cycle::safeEffort(std::uint32_t joint) const noexcept {
  const double carried = std::isfinite(torques_[joint]) ? torques_[joint] : 0;
  return carried - settings_.safe_damping * measured_.joints[joint].link_velocity;
}

void Cycle::holdRest() noexcept {
  bool at_rest = ending_.load(std::memory_order_relaxed);
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    JointControl& control = joints_[j];
    if (held_[j]) {
      const link::Control why = control.isSafe()                   ? link::Control::kSafe
                                : control.owner() == link::kNobody ? link::Control::kFree
                                                                   : link::Control::kHolding;
      control.hold(why, control.holdsByEffort() ? safeEffort(j) : 0);
    }
    at_rest = at_rest && control.isAtRest();
  }
  at_rest_.store(at_rest, std::memory_order_relaxed);
}

void Cycle::move() noexcept {
  std::transform(joints_.begin(), joints_.end(), references_.begin(),
                 [](const JointControl& joint) { return joint.reference(); });
  if (hal_->move(references_) != Status::kOk) link::relaxedAdd<std::uint64_t>(writer_.loop().move_failures, 1);
}

}  // namespace robotui::rt::hal
