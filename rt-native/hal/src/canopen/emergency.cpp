#include "emergency.h"

#include <array>
#include <cstdio>

namespace robotui::rt::hal::canopen {

namespace {

struct Meaning {
  std::uint16_t code;
  std::uint16_t mask;
  const char* text;
};

// The closest one first.
constexpr Meaning kMeanings[] = {
    {0x0000, 0xffff, "no error"},
    {0x2310, 0xffff, "continuous over-current"},
    {0x2320, 0xffff, "short circuit or earth leakage"},
    {0x2330, 0xffff, "earth leakage"},
    {0x2340, 0xffff, "short circuit at the motor"},
    {0x3110, 0xffff, "mains over-voltage"},
    {0x3120, 0xffff, "mains under-voltage"},
    {0x3210, 0xffff, "DC link over-voltage"},
    {0x3220, 0xffff, "DC link under-voltage"},
    {0x4210, 0xffff, "drive too hot"},
    {0x4310, 0xffff, "drive too hot"},
    {0x5112, 0xffff, "logic supply too low"},
    {0x5441, 0xffff, "enable or STO input was opened"},
    {0x6320, 0xffff, "parameter error"},
    {0x7121, 0xffff, "motor blocked"},
    {0x7122, 0xffff, "motor error or commutation malfunction"},
    {0x7300, 0xffff, "sensor error"},
    {0x7305, 0xffff, "encoder signal lost"},
    {0x7500, 0xffff, "communication error"},
    {0x8110, 0xffff, "CAN overrun: frames were lost"},
    {0x8120, 0xffff, "CAN in error passive mode"},
    {0x8130, 0xffff, "it missed the heartbeat of the control"},
    {0x8140, 0xffff, "it recovered from bus-off"},
    {0x8150, 0xffff, "two nodes send with one identifier"},
    {0x8210, 0xffff, "a PDO was too short"},
    {0x8220, 0xffff, "a PDO was too long"},
    {0x8250, 0xffff, "a PDO did not come in time"},
    {0x8611, 0xffff, "following error too large"},
    {0x8612, 0xffff, "position limit exceeded"},
    {0x2000, 0xf000, "current"},
    {0x3000, 0xf000, "voltage"},
    {0x4000, 0xf000, "temperature"},
    {0x5000, 0xf000, "hardware of the drive"},
    {0x6000, 0xf000, "software of the drive"},
    {0x7000, 0xf000, "additional modules: encoder, brake, motor"},
    {0x8100, 0xff00, "communication"},
    {0x8200, 0xff00, "protocol error"},
    {0x8300, 0xff00, "torque control"},
    {0x8400, 0xff00, "velocity control"},
    {0x8500, 0xff00, "position control"},
    {0x8600, 0xff00, "positioning"},
    {0x8000, 0xf000, "monitoring"},
    {0x9000, 0xf000, "external error"},
    {0xff00, 0xff00, "of the maker of the drive: see its manual"},
    {0xf000, 0xf000, "additional functions"},
    {0x1000, 0xf000, "generic error"},
};

const char* meaningOf(std::uint16_t code) noexcept {
  for (const Meaning& each : kMeanings)
    if ((code & each.mask) == each.code) return each.text;
  return "unknown";
}

}  // namespace

std::string errorText(std::uint16_t code) {
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "0x%04X", code);
  return std::string(number.data()) + " (" + meaningOf(code) + ")";
}

}  // namespace robotui::rt::hal::canopen
