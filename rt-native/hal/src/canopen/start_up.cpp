#include "start_up.h"

#include <cmath>
#include <stdexcept>

#include "robotui/rt/link/clock.h"
#include "sdo.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr int kFirstQuestions = 6;  // each a quarter of sdo_timeout_ms: a drive that was just switched on is silent

std::int8_t firstMode(const Ways& ways) noexcept {
  const OperationMode mode = ways.position   ? OperationMode::kSyncPosition
                             : ways.velocity ? OperationMode::kSyncVelocity
                                             : OperationMode::kSyncTorque;
  return static_cast<std::int8_t>(mode);
}

void identify(const SdoClient& sdo) {
  const std::uint32_t type = sdo.read(kDeviceType);
  if ((type & 0xffffU) != kDriveProfile)
    throw std::runtime_error("it is no drive of CiA 402 but of profile " + std::to_string(type & 0xffffU) +
                             " (0x1000): look at the node in HALInterface.params.drives");
}

// Each watches the other: a drive whose control died must stop by itself.
void watchEachOther(const SdoClient& sdo, const Settings& settings, std::vector<std::string>& warnings) {
  const auto ms = [](std::int64_t ns) { return static_cast<std::uint32_t>(ns / link::kMillisecond); };
  sdo.write(kHeartbeatProducer, ms(settings.heartbeat_ns), 2);
  if (!sdo.writeIfThere(kHeartbeatConsumer, std::uint32_t{settings.own_node} << 16U | ms(settings.heartbeat_timeout_ns),
                        4))
    warnings.emplace_back(
        "cannot watch the heartbeat of the control (0x1016): it will not notice by itself when that ends");
}

// As ten to an exponent: 250 us is 25 with -5.
void sayPeriod(const SdoClient& sdo, std::int64_t period_ns) {
  std::int64_t mantissa = period_ns / link::kMicrosecond;
  int exponent = -6;
  for (; mantissa % 10 == 0 && mantissa > 0; mantissa /= 10) ++exponent;
  if (mantissa >= 1 && mantissa <= 255) {
    sdo.writeIfThere(kInterpolationPeriod, static_cast<std::uint32_t>(mantissa), 1);
    sdo.writeIfThere(kInterpolationExponent, static_cast<std::uint8_t>(exponent), 1);
  }
  sdo.writeIfThere(kCyclePeriod, static_cast<std::uint32_t>(period_ns / link::kMicrosecond), 4);
}

// A second fence, in the drive itself.
void limit(const SdoClient& sdo, const DriveSettings& drive) {
  if (!std::isfinite(drive.lower) || !std::isfinite(drive.upper)) return;
  const auto counts = [&](double position) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround((position - drive.offset) * drive.counts)));
  };
  const bool turned = drive.counts < 0;
  sdo.writeIfThere(kLeastPosition, counts(turned ? drive.upper : drive.lower), 4);
  sdo.writeIfThere(kMostPosition, counts(turned ? drive.lower : drive.upper), 4);
}

// The first question is asked again while the drive may still be starting.
void awaitDrive(const Bus& bus, const Settings& settings, const DriveSettings& drive) {
  const SdoClient sdo(bus, drive.node, settings.sdo_timeout_ms / 4 + 1);
  for (int left = kFirstQuestions - 1;; --left) {
    bus.send(nmtFrame(NmtCommand::kPreOperational, drive.node));
    try {
      return identify(sdo);
    } catch (const SdoError& error) {
      if (error.abortCode() != 0 || left <= 0) throw;
    }
  }
}

void configure(const SdoClient& sdo, const Settings& settings, const DriveSettings& drive, StartUp& result) {
  watchEachOther(sdo, settings, result.warnings);
  sayPeriod(sdo, settings.period_ns);
  limit(sdo, drive);
  for (const GivenObject& given : drive.objects) sdo.write(given.object, given.value, given.size);
  sdo.write(kMode, static_cast<std::uint8_t>(firstMode(settings.ways)), 1);
  if (settings.writes_mapping) writeLayout(sdo, drive.node, settings.waysOf(drive));
  result.layout = readLayout(sdo, settings.waysOf(drive));
}

}  // namespace

std::string nameOf(const DriveSettings& drive) {
  return "The drive of '" + drive.joint + "' (node " + std::to_string(drive.node) + ")";
}

StartUp startUp(const Bus& bus, const Settings& settings, const DriveSettings& drive) {
  StartUp result;
  try {
    awaitDrive(bus, settings, drive);
    configure(SdoClient(bus, drive.node, settings.sdo_timeout_ms), settings, drive, result);
  } catch (const SdoError& error) {
    const bool silent = error.abortCode() == 0;
    throw std::runtime_error(
        nameOf(drive) + " cannot be made ready: " + error.what() +
        (silent ? ". Look at its supply, at the wires and their two terminators, at the bit rate, and at its node."
                : ". Look at what its manual says of this object; mapping: keep leaves its PDOs as they are."));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(nameOf(drive) + " cannot be made ready: " + error.what() + ".");
  }
  bus.send(nmtFrame(NmtCommand::kStart, drive.node));
  for (std::string& warning : result.warnings) warning = nameOf(drive) + " " + warning + ".";
  return result;
}

}  // namespace robotui::rt::hal::canopen
