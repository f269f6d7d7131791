#include "cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::hal {

namespace {

link::Counts countsOf(const config::RobotDescription& robot) noexcept {
  return link::bounded({static_cast<std::uint32_t>(robot.joints.size()), static_cast<std::uint32_t>(robot.imus.size()),
                        static_cast<std::uint32_t>(robot.force_torques.size())});
}

std::uint64_t cyclesInASecond(const CycleSettings& settings) noexcept {
  return static_cast<std::uint64_t>(
      std::max<std::int64_t>(1, link::kSecond / std::max<std::int64_t>(1, settings.period_ns)));
}

}  // namespace

Cycle::Cycle(const config::RobotDescription& robot, const CycleSettings& settings, Hal& hal,
             const link::BoardSegment& board, CommandInbox& inbox, SafeTorque& torque, link::StateSegment& state)
    : settings_(settings), hal_(&hal), board_(board), inbox_(&inbox), torque_(&torque), writer_(state, countsOf(robot)),
      falls_(countsOf(robot).joints, cyclesInASecond(settings)),
      stops_(settings.emergency_stops, cyclesInASecond(settings)) {
  const link::Counts counts = countsOf(robot);
  measured_ = {std::span(frame_.joints).first(counts.joints), std::span(frame_.imus).first(counts.imus),
               std::span(frame_.force_torques).first(counts.force_torques)};
  const double period_s = static_cast<double>(settings.period_ns) * 1e-9;
  for (std::uint32_t j = 0; j < counts.joints; ++j) joints_.emplace_back(robot.joints[j], period_s);
  references_.resize(counts.joints);
  torques_.resize(counts.joints);
  held_.resize(counts.joints);
  astray_.resize(counts.joints);
  settings_.following_errors.resize(counts.joints, std::numeric_limits<double>::infinity());
  link::relaxedStore(writer_.loop().period_ns, settings.period_ns);
}

void Cycle::run(std::uint64_t cycle, std::int64_t start_ns) noexcept {
  inbox_->begin();
  sense(cycle);
  falls_.begin(cycle, stops_.bits());
  assign(cycle);
  follow();
  publish(cycle);
  inbox_->collect(cycle,
                  start_ns + static_cast<std::int64_t>(settings_.deadline * static_cast<double>(settings_.period_ns)));
  link::relaxedStore(writer_.loop().missed_commands, inbox_->missed());
  apply();
  falls_.end();
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

// An emergency stop that is pressed explains what else the hardware says; one that cannot be read does not.
Status Cycle::shown(Status sensed) const noexcept {
  const bool is_told = stops_.isPressed() || (stops_.isStopped() && sensed == Status::kOk);
  return is_told ? Status::kEmergencyStop : sensed;
}

void Cycle::anchor() noexcept {
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].anchor(measured_.joints[j]);
}

// A robot that was away, or without power, may have been moved: then all goes on from where it is.
void Cycle::sense(std::uint64_t cycle) noexcept {
  Status status = hal_->sense(measured_);
  stops_.look(*hal_, cycle);
  if (!areNumbers()) {
    keepOld();
    status = Status::kFault;
  }
  frame_.hal_status = static_cast<std::uint32_t>(shown(status));
  frame_.sensed_ns = link::now();
  if (status != Status::kOk) {
    link::relaxedAdd<std::uint64_t>(writer_.loop().sense_failures, 1);
    silent_ = std::min(silent_ + 1, settings_.misses_before_safe);
    away_ = away_ || silent_ == settings_.misses_before_safe;
    return;
  }
  if (!sensed_ || away_ || stops_.wasReleased()) anchor();
  sensed_ = true;
  away_ = false;
  silent_ = 0;
  std::copy(measured_.joints.begin(), measured_.joints.end(), last_good_.joints.begin());
}

// Grant before owner: see BoardReader.
void Cycle::assign(std::uint64_t cycle) noexcept {
  const bool all_safe = away_ || stops_.isStopped() || ending_.load(std::memory_order_relaxed);
  groups_.look(cycle, *inbox_, all_safe);
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    const std::uint32_t granted = board_.grant(j);
    const auto [owner, grant] = groups_.holder(j, board_.owner(j), granted);
    if (joints_[j].belongs(owner, grant, measured_.joints[j])) inbox_->forgive(owner);
    if (stops_.isStopped()) fall(j, link::FallCause::kEmergency);
    if (away_) fall(j, link::FallCause::kHardware);
    if (all_safe) joints_[j].makeSafe();
    if (owner != link::kNobody && !joints_[j].isSafe()) inbox_->want(owner);
  }
}

// With the references of the cycle before, which are what the measurements answer to.
void Cycle::publish(std::uint64_t cycle) noexcept {
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].describe(frame_.joints[j]);
  frame_.cycle = cycle;
  frame_.switched = groups_.switched();
  writer_.publish(frame_);
  writer_.ring();
}

// What fell over, is blocked, or pushes against something is not where its plugin believes it to be. Where it is, it
// stays: it must not go on to push.
void Cycle::follow() noexcept {
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    JointControl& control = joints_[j];
    const double error = control.followingError(measured_.joints[j]);
    const bool is_led = silent_ == 0 && control.owner() != link::kNobody && !control.isSafe();
    astray_[j] = is_led && error > settings_.following_errors[j] ? astray_[j] + 1 : 0;
    if (astray_[j] < settings_.following_cycles) continue;
    fall(j, link::FallCause::kFollowing, error);
    control.anchor(measured_.joints[j]);
    astray_[j] = 0;
  }
}

bool Cycle::obey(std::uint32_t joint) noexcept {
  const JointControl& control = joints_[joint];
  if (control.isSafe() || control.owner() == link::kNobody) return false;
  switch (inbox_->answer(control.owner())) {
    case Answer::kFresh: return obeyAnswer(joint);
    case Answer::kMissed: return false;
    case Answer::kSafe: fall(joint, link::FallCause::kMissed); return false;
  }
  return false;
}

// What is no command is none that was missed: after as many in turn the joint is safe, too.
bool Cycle::obeyAnswer(std::uint32_t joint) noexcept {
  JointControl& control = joints_[joint];
  const std::uint16_t owner = control.owner();
  const link::JointCommand& command = inbox_->command(owner, joint);
  const bool is_new = inbox_->isNew(owner);
  if (!is_new && command.plugin != owner) return false;  // of before the joint changed hands within the thread
  const auto outcome = control.command(command, is_new);
  if (outcome == JointControl::Outcome::kRejected) {
    falls_.refused(joint, control);
    if (control.rejectedInTurn() >= settings_.misses_before_safe) fall(joint, link::FallCause::kRejected);
  }
  return outcome == JointControl::Outcome::kObeyed;
}

void Cycle::fall(std::uint32_t joint, link::FallCause cause, double error) noexcept {
  if (joints_[joint].isSafe()) return;
  joints_[joint].makeSafe();
  falls_.fell(joint, joints_[joint], cause, error);
}

// A plugin falls as a whole: it must not move a part of a robot whose other part does not obey it.
void Cycle::fallTogether() noexcept {
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    if (joints_[j].isSafe() || !falls_.hasFallen(joints_[j].owner())) continue;
    joints_[j].makeSafe();
    falls_.fellToo(j, joints_[j].owner());
    held_[j] = true;
  }
}

void Cycle::apply() noexcept {
  bool torque_needed = false;
  for (std::uint32_t j = 0; j < joints_.size(); ++j) held_[j] = !obey(j);
  fallTogether();
  for (std::uint32_t j = 0; j < joints_.size(); ++j) torque_needed |= held_[j] && joints_[j].holdsByEffort();
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
