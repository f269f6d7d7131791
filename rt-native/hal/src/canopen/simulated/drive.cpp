#include "drive.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::canopen::simulated {

namespace {

constexpr std::uint16_t kPdos = 4;
constexpr double kLongestStep = 0.1;  // s: a program that was halted does not leap
constexpr std::uint16_t kControlLost = 0x8130;

Object mappedBy(std::uint32_t entry) noexcept {
  return {static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>(entry >> 8U)};
}

bool isOn(std::uint32_t identifier) noexcept { return (identifier & kPdoOff) == 0; }

}  // namespace

Drive::Drive(std::uint8_t node, double position_counts, Send send)
    : node_(node), send_(std::move(send)), dictionary_(node), motor_(position_counts) {
  publishState();
}

void Drive::send(const Frame& frame) const {
  if (!ailments_.is_silent) send_(frame);
}

void Drive::restart() {
  dictionary_ = Dictionary(node_);
  motor_ = Motor(motor_.position());
  error_ = 0;
  control_ns_ = 0;
  nmt_ = NmtState::kPreOperational;
  publishState();
  send(frameOf(kHeartbeatId + node_, {static_cast<std::uint8_t>(NmtState::kBootUp)}));
}

void Drive::obeyNmt(const Frame& frame) {
  if (frame.can_dlc < 2 || (frame.data[1] != 0 && frame.data[1] != node_)) return;
  switch (static_cast<NmtCommand>(frame.data[0])) {
    case NmtCommand::kStart: nmt_ = NmtState::kOperational; break;
    case NmtCommand::kStop: nmt_ = NmtState::kStopped; break;
    case NmtCommand::kPreOperational: nmt_ = NmtState::kPreOperational; break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication: restart(); break;
    default: break;
  }
}

void Drive::heard(const Frame& frame, std::int64_t now_ns) {
  if (!isPlain(frame) || ailments_.is_silent) return;
  const std::uint32_t watched = dictionary_.get(kHeartbeatConsumer);
  if (frame.can_id == kNmtId) {
    obeyNmt(frame);
  } else if (frame.can_id == kSyncId && isOperational()) {
    sync(now_ns);
  } else if (frame.can_id == kSdoRequestId + node_ && frame.can_dlc == CAN_MAX_DLEN && nmt_ != NmtState::kStopped) {
    send(dictionary_.answer(frame));
  } else if (watched != 0 && frame.can_id == kHeartbeatId + ((watched >> 16U) & 0x7fU)) {
    control_ns_ = now_ns;
  } else if (isOperational()) {
    take(frame);
  }
}

void Drive::take(const Frame& frame) {
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo) {
    const std::uint32_t id = dictionary_.get({static_cast<std::uint16_t>(kReceivePdo + pdo), 1});
    if (!isOn(id) || (id & CAN_SFF_MASK) != frame.can_id) continue;
    const auto mapping = static_cast<std::uint16_t>(kReceiveMapping + pdo);
    std::size_t offset = 0;
    for (std::uint8_t sub = 1; sub <= dictionary_.get({mapping, 0}); ++sub) {
      const std::uint32_t entry = dictionary_.get({mapping, sub});
      const std::size_t size = (entry & 0xffU) / 8;
      if (offset + size > frame.can_dlc) return emergency(0x8210);
      dictionary_.set(mappedBy(entry), canopen::get(frame, offset, size));
      offset += size;
    }
  }
}

void Drive::sync(std::int64_t now_ns) {
  const double seconds = moved_ns_ == 0 ? 0 : std::min(static_cast<double>(now_ns - moved_ns_) * 1e-9, kLongestStep);
  moved_ns_ = now_ns;
  motor_.control(static_cast<std::uint16_t>(dictionary_.get(kControlWord)));
  if (motor_.wasReset()) emergency(0);
  motor_.move(
      {static_cast<std::int8_t>(dictionary_.get(kMode)), static_cast<std::int32_t>(dictionary_.get(kTargetPosition)),
       static_cast<std::int32_t>(dictionary_.get(kTargetVelocity)),
       static_cast<std::int16_t>(dictionary_.get(kTargetTorque))},
      seconds);
  publishState();
  if (!ailments_.sends_no_state) sendStates();
}

void Drive::publishState() {
  dictionary_.set(kStatusWord, motor_.statusWord());
  dictionary_.set(kModeShown, dictionary_.get(kMode));
  dictionary_.set(kErrorCode, error_);
  dictionary_.set(kPositionActual, static_cast<std::uint32_t>(motor_.position()));
  dictionary_.set(kVelocityActual, static_cast<std::uint32_t>(motor_.velocity()));
  dictionary_.set(kTorqueActual, static_cast<std::uint16_t>(motor_.torque()));
}

void Drive::sendStates() {
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo) {
    const std::uint32_t id = dictionary_.get({static_cast<std::uint16_t>(kTransmitPdo + pdo), 1});
    const auto mapping = static_cast<std::uint16_t>(kTransmitMapping + pdo);
    if (!isOn(id) || dictionary_.get({mapping, 0}) == 0) continue;
    Frame frame = frameOf(id & CAN_SFF_MASK, {});
    for (std::uint8_t sub = 1; sub <= dictionary_.get({mapping, 0}); ++sub) {
      const std::uint32_t entry = dictionary_.get({mapping, sub});
      const std::size_t size = (entry & 0xffU) / 8;
      put(frame, frame.can_dlc, size, dictionary_.get(mappedBy(entry)));
      frame.can_dlc = static_cast<std::uint8_t>(std::min<std::size_t>(frame.can_dlc + size, CAN_MAX_DLEN));
    }
    send(frame);
  }
}

void Drive::emergency(std::uint16_t code) {
  error_ = code;
  dictionary_.set(kErrorCode, code);
  dictionary_.set({0x1001}, code == 0 ? 0 : 1);
  Frame frame = frameOf(kEmergencyId + node_, {0, 0, static_cast<std::uint8_t>(code == 0 ? 0 : 1), 0, 0, 0, 0, 0});
  put(frame, 0, 2, code);
  send(frame);
}

void Drive::fail(std::uint16_t code) {
  motor_.fail();
  emergency(code);
  publishState();
}

// A drive whose control fell silent stops by itself.
void Drive::watchControl(std::int64_t now_ns) {
  const std::uint32_t watched = dictionary_.get(kHeartbeatConsumer);
  const std::int64_t timeout = (watched & 0xffffU) * link::kMillisecond;
  if (watched == 0 || control_ns_ == 0 || now_ns - control_ns_ <= timeout) return;
  control_ns_ = 0;
  if (isOperational() && motor_.state() == DriveState::kEnabled) fail(kControlLost);
}

void Drive::step(std::int64_t now_ns) {
  watchControl(now_ns);
  const std::int64_t beat = dictionary_.get(kHeartbeatProducer) * link::kMillisecond;
  if (beat == 0 || ailments_.sends_no_heartbeat || now_ns - beat_ns_ < beat) return;
  beat_ns_ = now_ns;
  send(frameOf(kHeartbeatId + node_, {static_cast<std::uint8_t>(nmt_)}));
}

}  // namespace robotui::rt::hal::canopen::simulated
