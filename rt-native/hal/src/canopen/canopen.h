// A robot whose joints are drives on a CAN bus: CANopen with the profile of drives, CiA 402.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "../notices.h"
#include "bus.h"
#include "bus_watch.h"
#include "drive.h"
#include "robotui/rt/hal/hal.h"
#include "robotui/rt/link/spsc_queue.h"
#include "settings.h"

namespace robotui::rt::hal::canopen {

// Parameters: docs/rt-canopen.md. In a cycle: all that came is read, targets and control words are sent, and then SYNC,
// upon which the drives take the targets and send their states. What waits for answers (SDO) has a socket of its own,
// on ordinary threads.
class CanOpen : public Hal {
 public:
  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  Status sense(Measurements& into) noexcept override;
  Status move(std::span<const Reference> references) noexcept override;
  void senseStops(std::span<StopInput> into) noexcept override;
  void close() noexcept override;
  std::vector<std::string> news() override;
  std::vector<std::string> recover() override;
  std::vector<DriveReport> drives() override;
  std::vector<std::string> enable(bool wanted) override;

 private:
  enum class Kind : std::uint8_t { kNone, kState, kHeartbeat, kEmergency };
  struct Route {  // of an identifier
    Kind kind = Kind::kNone;
    std::uint8_t drive = 0;
    std::uint8_t pdo = 0;
  };

  void startDrives(const config::Place& place);
  void routeTo(std::uint8_t drive, const PdoLayout& layout);
  void tellLost(std::int64_t now_ns);
  std::size_t drain(std::int64_t now_ns) noexcept;
  void heard(const Frame& frame, std::int64_t now_ns) noexcept;
  Status judge() const noexcept;
  void exchange(std::span<const Reference> references, std::int64_t now_ns) noexcept;
  bool send(const Frame& frame) noexcept;
  void tell(const Alarm& alarm) noexcept;
  void switchOff() noexcept;
  std::vector<std::string> bringBack(DrivePhase phase);
  std::string retry(Drive& drive, const DriveSettings& settings);

  Settings settings_;
  std::optional<Bus> service_;
  std::optional<Bus> bus_;
  std::optional<BusWatch> watch_;
  std::vector<std::unique_ptr<Drive>> drives_;
  std::array<Route, kIdentifiers> routes_{};
  std::int64_t beat_ns_ = 0;  // of our last heartbeat
  bool was_asked_ = false;    // a SYNC went out since the last look
  bool was_moved_ = false;    // since the last sense
  bool is_led_ = false;       // the robot as a whole
  link::SpscQueue<Alarm, 256> alarms_;
  Notices notices_;
  std::vector<std::string> warnings_;
  std::vector<std::uint64_t> told_lost_;  // by drive
};

}  // namespace robotui::rt::hal::canopen
