// One drive in the cycle: what came from it, whether it can be relied on, and what to send it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>

#include "alarm.h"
#include "frame.h"
#include "pdo_layout.h"
#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal::canopen {

// How one stood in the last cycle.
struct ShownDrive {
  DrivePhase phase = DrivePhase::kEnabling;
  DriveState state = DriveState::kNotReady;
  std::uint16_t error = 0;  // of its last emergency
};

// On the real-time thread, but for what is said to be for others. Nothing waits or allocates.
class Drive {
 public:
  // `now_ns` is when watching and enabling begin.
  Drive(const Settings& settings, std::uint16_t index, const PdoLayout& layout, std::int64_t now_ns) noexcept;

  // ---- what came
  void heardState(std::uint8_t pdo, const Frame& frame) noexcept;
  void heardHeartbeat(std::uint8_t state, std::int64_t now_ns) noexcept;
  void heardEmergency(const Frame& frame) noexcept;

  // ---- once a cycle, behind that
  // Judges it anew. What is new to tell: its emergency, what is missing, what it does; kNone where there is nothing.
  std::array<Alarm, 3> look(std::int64_t now_ns, bool was_asked) noexcept;
  // It is enabled and heard.
  bool isReady() const noexcept { return is_heard_ && phase_ == Phase::kEnabled; }
  // It must be brought back by hand.
  bool hasFallen() const noexcept { return phase_ == Phase::kFallen; }
  void measure(link::JointState& into) noexcept;
  // Its digital inputs (0x60FD); nothing where they were not heard lately.
  std::optional<std::uint32_t> inputs() const noexcept;

  // ---- what goes to it
  // `reference` is null where there is none. A drive begins to follow references when the robot as a whole can be led,
  // and goes on with it while others cannot: until then it holds.
  void command(const Reference* reference, bool robot_is_led) noexcept;
  // On the way out: the motor is switched off.
  void commandOff() noexcept;
  std::span<const Frame> frames() const noexcept { return std::span(frames_).first(frame_count_); }
  std::optional<Alarm> refusal() noexcept;  // of the last command

  // ---- from an ordinary thread
  void retry() noexcept { wish_.store(Wish::kOn, std::memory_order_release); }
  void disable() noexcept { wish_.store(Wish::kOff, std::memory_order_release); }
  std::uint64_t lostStates() const noexcept { return lost_.load(std::memory_order_relaxed); }
  ShownDrive shown() const noexcept { return shown_.load(std::memory_order_acquire); }
  const PdoLayout& layout() const noexcept { return layout_; }
  DriveState state() const noexcept { return stateOf(status_word_); }

 private:
  enum class Phase : std::uint8_t { kDisabled, kEnabling, kEnabled, kFallen };
  enum class Wish : std::uint8_t { kNone, kOn, kOff };

  Alarm alarm(Cause cause, std::uint32_t detail = 0) const noexcept;
  Alarm fall(Cause cause, std::uint32_t detail = 0) noexcept;
  Alarm emergency() noexcept;
  Alarm advance(std::int64_t now_ns) noexcept;
  Alarm watch(std::int64_t now_ns, bool was_asked) noexcept;
  void begin(std::int64_t now_ns) noexcept;
  void obey(Wish wish, std::int64_t now_ns) noexcept;
  ShownDrive toShow() const noexcept;
  void lead(const Reference& reference) noexcept;
  void set(const Field& field, std::uint32_t value) noexcept;
  std::uint32_t counts(double position) const noexcept;
  double position() const noexcept;
  double turn() const noexcept;

  const Settings& settings_;
  const DriveSettings& drive_;
  PdoLayout layout_;
  std::uint16_t index_;
  std::array<Frame, kPdos> frames_{};
  std::array<std::uint8_t, kPdos> frame_of_{};  // by RPDO
  std::size_t frame_count_ = 0;

  Phase phase_ = Phase::kEnabling;
  std::int64_t enable_by_ns_ = 0;
  std::int64_t heartbeat_ns_ = 0;
  std::uint64_t cycle_ = 0;
  std::uint32_t missed_ = 0;  // cycles in turn without its state
  std::uint16_t status_word_ = 0;
  std::uint16_t error_ = 0;  // of its last emergency
  std::uint16_t told_error_ = 0;
  std::uint8_t nmt_ = static_cast<std::uint8_t>(NmtState::kOperational);
  std::int32_t position_counts_ = 0;
  std::int32_t velocity_counts_ = 0;
  std::int16_t torque_counts_ = 0;
  std::uint32_t inputs_ = 0;
  std::uint32_t inputs_missed_ = 0;  // cycles in turn without them
  bool has_inputs_ = false;          // in this cycle
  bool knows_inputs_ = false;        // ever
  double hold_ = 0;                  // rad or m
  double velocity_ = 0;
  double measured_ = 0;     // rad or m of the cycle before
  bool has_state_ = false;  // in this cycle
  bool was_heard_ = false;  // its state ever
  bool is_heard_ = true;
  bool follows_ = false;  // the references of the robot
  std::uint8_t refused_mode_ = 0;
  std::atomic<std::uint64_t> lost_{0};
  std::atomic<Wish> wish_{Wish::kNone};
  std::atomic<ShownDrive> shown_{};
  static_assert(std::atomic<ShownDrive>::is_always_lock_free);
};

}  // namespace robotui::rt::hal::canopen
