#include "drive.h"

#include <algorithm>
#include <cmath>

#include "../one_way.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr std::uint64_t kEdgeCycles = 8;  // between two edges that reset a fault
constexpr double kMostCounts = 2'147'483'647.0;
constexpr double kMostTorque = 32'767.0;
constexpr std::uint32_t kFaultSign = 0x1'0000;  // of JointState.fault: the drive cannot be relied on

std::uint32_t bounded(double value, double most) noexcept {
  const double sure = std::isfinite(value) ? std::clamp(value, -most, most) : 0;
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(sure)));
}

std::uint32_t modeWord(OperationMode mode) noexcept { return static_cast<std::uint8_t>(mode); }

}  // namespace

Drive::Drive(const Settings& settings, std::uint16_t index, const PdoLayout& layout, std::int64_t now_ns) noexcept
    : settings_(settings), drive_(settings.drives[index]), layout_(layout), index_(index) {
  for (std::size_t pdo = 0; pdo < kPdos; ++pdo) {
    if (layout.receive[pdo].id == 0) continue;
    Frame& frame = frames_[frame_count_];
    frame.can_id = layout.receive[pdo].id;
    frame.can_dlc = layout.receive[pdo].length;
    frame_of_[pdo] = static_cast<std::uint8_t>(frame_count_++);
  }
  begin(now_ns);
  if (!settings.enables) obey(Wish::kOff, now_ns);
  shown_.store(toShow(), std::memory_order_release);
}

void Drive::begin(std::int64_t now_ns) noexcept {
  phase_ = Phase::kEnabling;
  enable_by_ns_ = now_ns + settings_.enable_timeout_ns;
  heartbeat_ns_ = now_ns;
  nmt_ = static_cast<std::uint8_t>(NmtState::kOperational);
  missed_ = 0;
  follows_ = false;
  is_heard_ = true;
  error_ = told_error_ = 0;
}

// One in fault stays so: only recover() resets it.
void Drive::obey(Wish wish, std::int64_t now_ns) noexcept {
  if (wish == Wish::kOn) {
    begin(now_ns);
  } else if (wish == Wish::kOff && phase_ != Phase::kFallen) {
    phase_ = Phase::kDisabled;
    follows_ = false;
  }
}

ShownDrive Drive::toShow() const noexcept {
  const DrivePhase phase = phase_ == Phase::kFallen     ? DrivePhase::kFault
                           : !is_heard_                 ? DrivePhase::kSilent
                           : phase_ == Phase::kDisabled ? DrivePhase::kDisabled
                           : phase_ == Phase::kEnabled  ? DrivePhase::kEnabled
                                                        : DrivePhase::kEnabling;
  return {phase, state(), error_};
}

// Shorter ones than the drive said are none of ours.
void Drive::heardState(std::uint8_t pdo, const Frame& frame) noexcept {
  if (frame.can_dlc < layout_.transmit[pdo].length) return;
  const auto read = [&](const Field& field, auto& into) {
    if (field.pdo == pdo)
      into = static_cast<std::remove_reference_t<decltype(into)>>(get(frame, field.offset, field.size));
  };
  read(layout_.status_word, status_word_);
  read(layout_.position, position_counts_);
  read(layout_.velocity, velocity_counts_);
  read(layout_.torque, torque_counts_);
  read(layout_.inputs, inputs_);
  if (layout_.position.pdo == pdo) has_state_ = true;
  if (layout_.inputs.pdo == pdo) has_inputs_ = true;
}

void Drive::heardHeartbeat(std::uint8_t state, std::int64_t now_ns) noexcept {
  heartbeat_ns_ = now_ns;
  nmt_ = state & 0x7fU;
}

void Drive::heardEmergency(const Frame& frame) noexcept {
  if (frame.can_dlc >= 2) error_ = static_cast<std::uint16_t>(get(frame, 0, 2));
}

Alarm Drive::alarm(Cause cause, std::uint32_t detail) const noexcept { return {cause, state(), index_, detail}; }

Alarm Drive::fall(Cause cause, std::uint32_t detail) noexcept {
  phase_ = Phase::kFallen;
  follows_ = false;
  return alarm(cause, detail);
}

// What the drive said of itself: where it is not enabled any more it takes a person to go on.
Alarm Drive::advance(std::int64_t now_ns) noexcept {
  if (phase_ == Phase::kFallen || phase_ == Phase::kDisabled) return {};
  const bool operational = nmt_ == static_cast<std::uint8_t>(NmtState::kOperational);
  const bool enabled = was_heard_ && state() == DriveState::kEnabled;
  if (phase_ == Phase::kEnabled && !operational) return fall(Cause::kRestarted, nmt_);
  if (phase_ == Phase::kEnabled) return enabled ? Alarm{} : fall(Cause::kFault, error_);
  if (enabled && operational) {
    phase_ = Phase::kEnabled;
    hold_ = position();
    return alarm(Cause::kEnabled);
  }
  if (now_ns <= enable_by_ns_) return {};
  return operational ? fall(Cause::kNotEnabled, status_word_) : fall(Cause::kRestarted, nmt_);
}

// What is missing may come again by itself.
Alarm Drive::watch(std::int64_t now_ns, bool was_asked) noexcept {
  if (has_state_) {
    missed_ = 0;
  } else if (was_asked) {
    missed_ = std::min(missed_ + 1, settings_.missed_pdos);
    lost_.store(lost_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  if (was_asked || has_inputs_) inputs_missed_ = has_inputs_ ? 0 : std::min(inputs_missed_ + 1, settings_.missed_pdos);
  knows_inputs_ = knows_inputs_ || has_inputs_;
  has_inputs_ = false;
  was_heard_ = was_heard_ || has_state_;
  has_state_ = false;
  const bool no_heartbeat = now_ns - heartbeat_ns_ > settings_.heartbeat_timeout_ns;
  const bool heard = missed_ < settings_.missed_pdos && !no_heartbeat;
  if (heard == is_heard_) return {};
  is_heard_ = heard;
  return alarm(heard ? Cause::kIsBack : no_heartbeat ? Cause::kNoHeartbeat : Cause::kNoState);
}

Alarm Drive::emergency() noexcept {
  if (told_error_ == error_) return {};
  told_error_ = error_;
  return alarm(Cause::kEmergency, error_);
}

// All of it in each cycle: a drive in fault must not count as enabled while there is something else to tell.
std::array<Alarm, 3> Drive::look(std::int64_t now_ns, bool was_asked) noexcept {
  ++cycle_;
  obey(wish_.exchange(Wish::kNone, std::memory_order_acquire), now_ns);
  const Alarm missing = watch(now_ns, was_asked);
  const Alarm state = advance(now_ns);
  shown_.store(toShow(), std::memory_order_release);
  return {emergency(), missing, state};
}

// Who turns the other way pushes the other way, too.
double Drive::turn() const noexcept { return drive_.counts < 0 ? -1 : 1; }

double Drive::position() const noexcept { return position_counts_ / drive_.counts + drive_.offset; }

void Drive::measure(link::JointState& into) noexcept {
  const double period_s = static_cast<double>(settings_.period_ns) * 1e-9;
  const double now = was_heard_ ? position() : into.link_position;
  const double velocity = layout_.velocity.isThere() ? velocity_counts_ / drive_.velocity_scale
                          : isReady()                ? (now - measured_) / period_s
                                                     : 0;
  measured_ = now;
  into.link_position = into.motor_position = now;
  into.link_velocity = into.motor_velocity = velocity;
  into.effort = torque_counts_ * turn() * drive_.rated_effort / 1000;
  velocity_ = velocity;
  into.fault = error_ | (is_heard_ && phase_ != Phase::kFallen ? 0 : kFaultSign);
}

std::optional<std::uint32_t> Drive::inputs() const noexcept {
  const bool is_known = knows_inputs_ && is_heard_ && inputs_missed_ < settings_.missed_pdos;
  return is_known ? std::optional(inputs_) : std::nullopt;
}

std::uint32_t Drive::counts(double position) const noexcept {
  return bounded((position - drive_.offset) * drive_.counts, kMostCounts);
}

void Drive::set(const Field& field, std::uint32_t value) noexcept {
  if (field.isThere()) put(frames_[frame_of_[field.pdo]], field.offset, field.size, value);
}

// Everything that the drive does not follow now is set so that it may change over to it at any time.
void Drive::lead(const Reference& reference) noexcept {
  const Command told = commandOf(reference, {position(), velocity_, 0}, settings_.ways.effort, drive_.most_effort);
  const bool refused =
      (told.way == Way::kVelocity && !settings_.ways.velocity) || (told.way == Way::kEffort && !settings_.ways.effort);
  refused_mode_ = refused ? reference.mode : 0;
  const Way way = refused ? Way::kPosition : told.way;
  if (told.way == Way::kPosition)
    hold_ = told.value;
  else if (!refused)
    hold_ = position();
  set(layout_.target_position, counts(hold_));
  set(layout_.target_velocity, way == Way::kVelocity ? bounded(told.value * drive_.velocity_scale, kMostCounts) : 0);
  set(layout_.target_torque,
      way == Way::kEffort ? bounded(told.value * turn() / drive_.rated_effort * 1000, kMostTorque) : 0);
  set(layout_.mode, modeWord(way == Way::kVelocity ? OperationMode::kSyncVelocity
                             : way == Way::kEffort ? OperationMode::kSyncTorque
                                                   : OperationMode::kSyncPosition));
}

// Until the robot can be led, an enabled drive holds where it was enabled; one that is not goes on from where it is.
void Drive::command(const Reference* reference, bool robot_is_led) noexcept {
  follows_ = phase_ == Phase::kEnabled && (follows_ || robot_is_led);
  const bool is_led = follows_ && reference != nullptr;
  if (phase_ != Phase::kEnabled) hold_ = position();
  lead(is_led ? *reference : Reference{hold_, 0, 0, 0, 0, link::kPosition});
  const bool edge = (cycle_ / kEdgeCycles) % 2 == 1;
  const bool is_off = phase_ == Phase::kFallen || phase_ == Phase::kDisabled || !was_heard_;
  set(layout_.control_word, is_off ? kDisableVoltage : towardsEnabled(state(), edge));
}

void Drive::commandOff() noexcept {
  hold_ = position();
  lead({hold_, 0, 0, 0, 0, link::kPosition});
  set(layout_.control_word, kShutDown);
}

std::optional<Alarm> Drive::refusal() noexcept {
  if (refused_mode_ == 0) return {};
  return alarm(Cause::kRefusedMode, refused_mode_);
}

}  // namespace robotui::rt::hal::canopen
