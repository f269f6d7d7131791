#include "alarm.h"

#include "emergency.h"
#include "frame.h"
#include "start_up.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr const char* kRecover =
    " All joints are safe. When the cause is gone: robotui-rt-ctl recover, and start the plugin again.";
constexpr const char* kByItself = " All joints are safe. When that is over, start the plugin again.";

std::string nmtName(std::uint32_t state) {
  switch (static_cast<NmtState>(state)) {
    case NmtState::kBootUp: return "has started anew";
    case NmtState::kStopped: return "was stopped by a command on the bus (NMT)";
    case NmtState::kPreOperational: return "went into 'pre-operational'";
    default: return "is in the unknown state " + std::to_string(state) + " of NMT";
  }
}

std::string msOf(std::int64_t ns) { return std::to_string(ns / 1'000'000) + " ms"; }

std::string ofDrive(const Alarm& alarm, const Settings& settings) {
  const std::string name = nameOf(settings.drives[alarm.drive]);
  const auto code = static_cast<std::uint16_t>(alarm.detail);
  switch (alarm.cause) {
    case Cause::kEmergency:
      return code == 0 ? name + " reports that its errors are over."
                       : name + " reports the error " + errorText(code) + ".";
    case Cause::kFault:
      return name + " is no longer enabled: it is in '" + nameOf(alarm.state) + "'" +
             (code == 0 ? "" : ", with the error " + errorText(code)) + "." + kRecover;
    case Cause::kNotEnabled:
      return name + " does not reach 'operation enabled' within " + msOf(settings.enable_timeout_ns) +
             ": it stays in '" + nameOf(alarm.state) + "'; " + hintFor(alarm.state) + "." + kRecover;
    case Cause::kNoState:
      return name + " sent no state (PDO) in " + std::to_string(settings.missed_pdos) +
             " cycles: frames are lost, or the bus is too busy." + kByItself;
    case Cause::kNoHeartbeat:
      return name + " sent no heartbeat for " + msOf(settings.heartbeat_timeout_ns) +
             ": look at its supply and at the wires." + kByItself;
    case Cause::kRestarted: return name + " " + nmtName(alarm.detail) + "." + kRecover;
    case Cause::kRefusedMode:
      return name + " holds its position: a plugin leads it in another way than `modes` of HALInterface.params names.";
    case Cause::kIsBack: return name + " is heard again.";
    case Cause::kEnabled: return name + " is enabled.";
    default: return {};
  }
}

}  // namespace

std::string sentenceOf(const Alarm& alarm, const Settings& settings) {
  const std::string bus = "The CAN bus " + settings.interface;
  switch (alarm.cause) {
    case Cause::kNone: return {};
    case Cause::kBusOff:
      return bus + " is off: the controller gave up after too many errors (wires, terminators, bit rate)." + kRecover +
             " Unless restart-ms is set for the interface, as root first: ip link set " + settings.interface +
             " type can restart.";
    case Cause::kBusDown:
      return bus + " is down." + kRecover + " As root first: ip link set " + settings.interface + " up.";
    case Cause::kBusFull:
      return bus + " takes no more frames: nobody acknowledges them, or they are too many for the bit rate." +
             kByItself;
    case Cause::kBusPassive: return bus + " has many errors: look at wires, terminators and the bit rate.";
    case Cause::kBusBack: return bus + " works again.";
    default: return alarm.drive < settings.drives.size() ? ofDrive(alarm, settings) : std::string();
  }
}

}  // namespace robotui::rt::hal::canopen
