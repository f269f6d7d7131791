// The robot's hardware, or what stands for it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/abi.h"
#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/push.h"

namespace robotui::rt::hal {

enum class Status : std::uint32_t {
  kOk = 0,
  kTimeout = 1,       // nothing came in time: what was sensed is the last there was
  kFault = 2,         // the hardware says that it cannot go on
  kEmergencyStop = 3  // of the control, not of a Hal: an emergency stop is pressed, or cannot be read
};

// What was measured. Sizes do not change after open().
struct Measurements {
  std::span<link::JointState> joints;  // a Hal writes the measured fields, temperatures, fault; nothing else
  std::span<link::ImuState> imus;
  std::span<link::ForceTorqueState> force_torques;
};

// What one joint is to do: within its limits, a mode always set.
struct Reference {
  double position;
  double velocity;
  double effort;
  double stiffness;
  double damping;
  std::uint8_t mode;
};

// Where one drive stands in its life.
enum class DrivePhase : std::uint8_t {
  kDisabled = 0,  // its motor is off, and stays so until a user enables it
  kEnabling = 1,
  kEnabled = 2,
  kFault = 3,  // its motor is off, and stays so until recover()
  kSilent = 4  // nothing is heard of it
};

// What an input says to which an emergency stop is wired.
enum class StopInput : std::uint8_t {
  kReleased = 0,
  kPressed = 1,
  kUnread = 2  // nothing is known of it, which counts as pressed
};

struct DriveReport {
  std::string joint;
  DrivePhase phase = DrivePhase::kDisabled;
  std::string detail;  // for the user, one line; may be empty
};

// One robot. open() and close() are called on an ordinary thread and may block and allocate; sense() and move() are
// called in turn on the real-time thread, once a cycle: they must not allocate, throw, or block longer than a fraction
// of the period.
class Hal {
 public:
  virtual ~Hal() = default;

  // Throws config::ConfigError or std::runtime_error with a sentence for the user. `period_ns` is the time between two
  // senses.
  virtual void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) = 0;

  virtual Status sense(Measurements& into) noexcept = 0;

  virtual Status move(std::span<const Reference> references) noexcept = 0;

  // What the emergency stops say, in the order of `HalConfig::emergency_stops`, of which there is at least one. Called
  // behind sense(), on the same terms. What is left as it was is kUnread: a HAL that does not read them keeps all
  // joints safe.
  virtual void senseStops(std::span<StopInput> /*into*/) noexcept {}

  virtual void close() noexcept = 0;

  // A user presses or releases an emergency stop that is simulated, by its index. False where they are real. From the
  // ordinary thread, between open() and close().
  virtual bool press(std::size_t /*stop*/, bool /*pressed*/) { return false; }

  // A user pushes a robot that is simulated, as a hand would: from now on, for as long as is said. Empty where it is
  // done, else a sentence why not. Called as press().
  virtual std::string push(const link::Push& /*push*/) {
    return "This kind of HAL cannot push the robot, since its forces are not those of a simulation: push it by hand.";
  }

  // What a user should know of the hardware since the last call: sentences. Called some times a second between open()
  // and close(), on the ordinary thread, so it may block and allocate.
  virtual std::vector<std::string> news() { return {}; }

  // A user asks to bring parts of the hardware back that do not come back by themselves, such as a drive after a fault.
  // Sentences of what was done. On the ordinary thread, between open() and close(); it may block for some seconds.
  virtual std::vector<std::string> recover() { return {"This kind of HAL has nothing that is to be brought back."}; }

  // Where its drives stand, by joint; empty where it has none that are enabled and disabled. Called as news().
  virtual std::vector<DriveReport> drives() { return {}; }

  // A user asks to enable the drives that are disabled, or to disable all of them; no plugin leads a joint then.
  // Sentences of what was done. Called as recover().
  virtual std::vector<std::string> enable(bool /*wanted*/) {
    return {"This kind of HAL has no drives that are enabled and disabled."};
  }
};

// What the library of a HAL of one's own exports, by ROBOTUI_RT_HAL(Class): its `lib_file` stands in the configuration.
// A library of another number, or that was built another way, is refused.
inline constexpr std::uint32_t kHalAbi = 8;

// Of this source file: internal linkage, so that no other file's list takes its place.
constexpr link::AbiFact kHalFacts[] = {
    ROBOTUI_RT_TOOLCHAIN_FACTS,
    ROBOTUI_RT_SIZE_OF(link::JointState),
    ROBOTUI_RT_SIZE_OF(link::Push),
    ROBOTUI_RT_SIZE_OF(config::RobotDescription),
    ROBOTUI_RT_SIZE_OF(config::HalConfig),
    {},
};

}  // namespace robotui::rt::hal

#define ROBOTUI_RT_HAL(Class)                                                                                  \
  extern "C" __attribute__((visibility("default"))) std::uint32_t robotui_rt_hal_abi() {                       \
    return robotui::rt::hal::kHalAbi;                                                                          \
  }                                                                                                            \
  extern "C" __attribute__((visibility("default"))) const robotui::rt::link::AbiFact* robotui_rt_hal_facts() { \
    return robotui::rt::hal::kHalFacts;                                                                        \
  }                                                                                                            \
  extern "C" __attribute__((visibility("default"))) robotui::rt::hal::Hal* robotui_rt_hal_create() {           \
    return new Class();                                                                                        \
  }
