#include "canopen.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include "emergency.h"
#include "robotui/rt/link/clock.h"
#include "start_up.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr double kMostLoad = 0.95;
constexpr std::size_t kMostOthers = 64;  // frames of one cycle that are none of our drives'
constexpr std::int64_t kSwitchingOff = link::kSecond / 2;

std::string rounded(double value) { return std::to_string(static_cast<int>(std::ceil(value))); }

// One that can come again without anybody's doing is told at most once in ten seconds.
bool comesAndGoes(Cause cause) noexcept {
  return cause != Cause::kFault && cause != Cause::kNotEnabled && cause != Cause::kRestarted &&
         cause != Cause::kEnabled;
}

}  // namespace

void CanOpen::open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) {
  settings_ = readSettings(robot, config, period_ns);
  service_.emplace(Bus::open(settings_.interface));
  service_->hearOnly(kSdoAnswerId, CAN_SFF_MASK & ~0x7fU);
  startDrives(config.place);
  watch_.emplace(settings_.missed_pdos);
}

void CanOpen::startDrives(const config::Place& place) {
  std::size_t frames = 0;
  std::vector<PdoLayout> layouts;
  for (const DriveSettings& drive : settings_.drives) {
    StartUp started = startUp(*service_, settings_, drive);
    frames += started.layout.frames();
    layouts.push_back(started.layout);
    warnings_.insert(warnings_.end(), started.warnings.begin(), started.warnings.end());
  }
  if (const double load = loadOf(settings_, frames); load > kMostLoad)
    throw config::ConfigError(place, std::to_string(frames + 1) + " frames in each cycle need up to " +
                                         rounded(load * static_cast<double>(settings_.period_ns) / 1000) +
                                         " us of the bus at " + std::to_string(settings_.bitrate) +
                                         " bit/s, and the period is " + std::to_string(settings_.period_ns / 1000) +
                                         " us: write a longer period_us, fewer modes, or a higher bitrate.");
  bus_.emplace(Bus::open(settings_.interface));
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    drives_.push_back(std::make_unique<Drive>(settings_, static_cast<std::uint16_t>(i), layouts[i], link::now()));
    routeTo(static_cast<std::uint8_t>(i), layouts[i]);
  }
}

void CanOpen::routeTo(std::uint8_t drive, const PdoLayout& layout) {
  const std::uint8_t node = settings_.drives[drive].node;
  const auto route = [&](canid_t id, Route to) {
    if (routes_[id].kind != Kind::kNone)
      throw std::runtime_error(nameOf(settings_.drives[drive]) + " sends with the identifier " + std::to_string(id) +
                               ", and so does " + nameOf(settings_.drives[routes_[id].drive]) +
                               ": give its PDOs identifiers of their own, or write mapping: write.");
    routes_[id] = to;
  };
  route(kHeartbeatId + node, {Kind::kHeartbeat, drive, 0});
  route(kEmergencyId + node, {Kind::kEmergency, drive, 0});
  for (std::size_t pdo = 0; pdo < kPdos; ++pdo)
    if (layout.transmit[pdo].id != 0)
      route(layout.transmit[pdo].id, {Kind::kState, drive, static_cast<std::uint8_t>(pdo)});
}

void CanOpen::tell(const Alarm& alarm) noexcept {
  if (alarm.cause != Cause::kNone) alarms_.push(alarm);
}

void CanOpen::heard(const Frame& frame, std::int64_t now_ns) noexcept {
  watch_->heard(frame);
  if (!isPlain(frame)) return;
  const Route route = routes_[frame.can_id & CAN_SFF_MASK];
  if (route.kind == Kind::kNone) return;
  Drive& drive = *drives_[route.drive];
  switch (route.kind) {
    case Kind::kState: drive.heardState(route.pdo, frame); break;
    case Kind::kHeartbeat:
      if (frame.can_dlc >= 1) drive.heardHeartbeat(frame.data[0], now_ns);
      break;
    default: drive.heardEmergency(frame);
  }
}

// A bounded number: a bus that is flooded does not keep the cycle.
std::size_t CanOpen::drain(std::int64_t now_ns) noexcept {
  const std::size_t most = drives_.size() * 16 + kMostOthers;
  Frame frame{};
  for (std::size_t count = 0; count < most; ++count) {
    const Heard outcome = bus_->receive(frame);
    if (outcome == Heard::kDown) watch_->heardDown();
    if (outcome != Heard::kFrame) return count;
    heard(frame, now_ns);
  }
  return most;
}

Status CanOpen::judge() const noexcept {
  bool ready = watch_->works();
  bool fallen = !ready;
  for (const auto& drive : drives_) {
    ready = ready && drive->isReady();
    fallen = fallen || drive->hasFallen();
  }
  return ready ? Status::kOk : fallen ? Status::kFault : Status::kTimeout;
}

// Before the robot was sensed for the first time nothing moves it, and yet the drives are to be asked and enabled.
Status CanOpen::sense(Measurements& into) noexcept {
  const std::int64_t now = link::now();
  drain(now);
  tell(watch_->look());
  for (std::size_t i = 0; i < drives_.size() && i < into.joints.size(); ++i) {
    for (const Alarm& alarm : drives_[i]->look(now, was_asked_)) tell(alarm);
    drives_[i]->measure(into.joints[i]);
  }
  const Status status = judge();
  is_led_ = status == Status::kOk;
  if (!was_moved_) exchange({}, now);
  was_moved_ = false;
  return status;
}

void CanOpen::senseStops(std::span<StopInput> into) noexcept {
  if (!watch_->works()) return;
  for (std::size_t i = 0; i < into.size() && i < settings_.stops.size(); ++i) {
    const StopSettings& stop = settings_.stops[i];
    const auto inputs = drives_[stop.drive]->inputs();
    if (!inputs) continue;
    into[i] = ((*inputs >> stop.input & 1U) != 0) == stop.closed ? StopInput::kReleased : StopInput::kPressed;
  }
}

Status CanOpen::move(std::span<const Reference> references) noexcept {
  was_moved_ = true;
  exchange(references, link::now());
  return watch_->works() ? Status::kOk : Status::kTimeout;
}

bool CanOpen::send(const Frame& frame) noexcept { return watch_->sent(bus_->send(frame)); }

// Where the bus takes no more, the rest of the cycle is not sent either: newer targets come soon.
void CanOpen::exchange(std::span<const Reference> references, std::int64_t now_ns) noexcept {
  was_asked_ = true;
  bool room = true;
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    drives_[i]->command(i < references.size() ? &references[i] : nullptr, is_led_);
    if (const auto refusal = drives_[i]->refusal()) tell(*refusal);
    for (const Frame& frame : drives_[i]->frames()) room = room && send(frame);
  }
  room = room && send(frameOf(kSyncId, {}));
  if (now_ns - beat_ns_ < settings_.heartbeat_ns) return;
  beat_ns_ = now_ns;
  if (room) send(frameOf(kHeartbeatId + settings_.own_node, {static_cast<std::uint8_t>(NmtState::kOperational)}));
}

// The joints are safe by now: the drives are switched off in order, and the motors with them.
void CanOpen::switchOff() noexcept {
  const auto enabled = [](const auto& drive) { return drive->state() == DriveState::kEnabled; };
  for (const std::int64_t end = link::now() + kSwitchingOff; link::now() < end;) {
    for (const auto& drive : drives_) {
      drive->commandOff();
      for (const Frame& frame : drive->frames()) send(frame);
    }
    send(frameOf(kSyncId, {}));
    std::this_thread::sleep_for(std::chrono::nanoseconds(settings_.period_ns));
    drain(link::now());
    if (std::none_of(drives_.begin(), drives_.end(), enabled) || !watch_->works()) break;
  }
  for (const DriveSettings& drive : settings_.drives) send(nmtFrame(NmtCommand::kPreOperational, drive.node));
}

void CanOpen::close() noexcept {
  if (bus_ && watch_) switchOff();
  bus_.reset();
  service_.reset();
}

std::vector<std::string> CanOpen::news() {
  const std::int64_t now = link::now();
  for (const std::string& warning : std::exchange(warnings_, {})) notices_.tell(warning, warning, now);
  std::vector<std::string> falls;
  for (Alarm alarm; alarms_.pop(alarm);) {
    const std::string sentence = sentenceOf(alarm, settings_);
    if (comesAndGoes(alarm.cause))
      notices_.tell(sentence, sentence, now);
    else
      falls.push_back(sentence);
  }
  tellLost(now);
  std::vector<std::string> sentences = notices_.take();
  sentences.insert(sentences.end(), falls.begin(), falls.end());
  return sentences;
}

void CanOpen::tellLost(std::int64_t now_ns) {
  told_lost_.resize(drives_.size());
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    const std::uint64_t lost = drives_[i]->lostStates();
    if (lost == told_lost_[i]) continue;
    told_lost_[i] = lost;
    const std::string name = nameOf(settings_.drives[i]);
    notices_.tell(
        "lost " + name,
        name + ": states (PDO) that did not come in their cycle since the start: " + std::to_string(lost) + ".",
        now_ns);
  }
}

std::string CanOpen::retry(Drive& drive, const DriveSettings& settings) {
  try {
    const StartUp started = startUp(*service_, settings_, settings);
    if (!(started.layout == drive.layout()))
      return nameOf(settings) + " has other PDOs than before: start the control again.";
    drive.retry();
    return nameOf(settings) + " is asked to be enabled again.";
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::vector<std::string> CanOpen::bringBack(DrivePhase phase) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < drives_.size(); ++i)
    if (drives_[i]->shown().phase == phase) sentences.push_back(retry(*drives_[i], settings_.drives[i]));
  return sentences;
}

std::vector<std::string> CanOpen::recover() {
  std::vector<std::string> sentences = bringBack(DrivePhase::kFault);
  if (sentences.empty()) sentences.emplace_back("No drive waits to be enabled again.");
  return sentences;
}

std::vector<std::string> CanOpen::enable(bool wanted) {
  if (wanted) {
    std::vector<std::string> sentences = bringBack(DrivePhase::kDisabled);
    if (sentences.empty()) sentences.emplace_back("No drive is disabled; one in fault is brought back by recover.");
    return sentences;
  }
  for (const auto& drive : drives_) drive->disable();
  return {"All drives are told to be disabled. Until they are enabled all joints are safe."};
}

std::vector<DriveReport> CanOpen::drives() {
  std::vector<DriveReport> reports;
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    const ShownDrive shown = drives_[i]->shown();
    const bool is_error = shown.phase == DrivePhase::kFault && shown.error != 0;
    reports.push_back(
        {settings_.drives[i].joint, shown.phase, is_error ? errorText(shown.error) : nameOf(shown.state)});
  }
  return reports;
}

}  // namespace robotui::rt::hal::canopen
