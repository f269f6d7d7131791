#include <algorithm>

#include "blocks.h"
#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/stop_bits.h"

namespace robotui::rt::config {
namespace {

constexpr int kMostInput = 31;
constexpr const char* kExample = "emergency_stops: {pendant: {joint: elbow, input: 16}}";

bool isName(const std::string& name) {
  return !name.empty() && name.size() < link::kNameLength &&
         std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; });
}

// Only drives on a bus have inputs of their own.
std::string jointOf(const Reader& stop, const RtConfig& config) {
  const auto joint = stop.find("joint");
  if (!joint) {
    if (config.hal.type == "canopen")
      stop.fail(std::string("needs the joint whose drive has the input; write ") + kExample);
    return {};
  }
  std::vector<std::string> known;
  for (const JointDescription& each : config.robot.joints) known.push_back(each.name);
  std::string name = joint->text();
  if (std::find(known.begin(), known.end(), name) == known.end())
    joint->fail("is '" + name + "', which is no joint of the joint map" + didYouMean(name, known));
  return name;
}

// Inputs of their own are counted where nothing is said; those of drives have meanings that only the user knows.
int inputOf(const Reader& stop, const HalConfig& hal) {
  if (hal.type == "canopen") return static_cast<int>(stop.at("input", "input: 16").whole(0, kMostInput));
  return static_cast<int>(stop.wholeOr("input", static_cast<long long>(hal.emergency_stops.size()), 0, kMostInput));
}

EmergencyStop readStop(const std::string& name, const Reader& stop, const RtConfig& config) {
  if (!isName(name)) stop.fail("needs a name of 1 to 63 characters, none of them a tab or a line break");
  stop.knowsOnly({"joint", "input", "closed"});
  EmergencyStop read;
  read.name = name;
  read.joint = jointOf(stop, config);
  read.input = inputOf(stop, config.hal);
  read.closed = stop.flagOr("closed", true);
  read.place = stop.place();
  for (const EmergencyStop& other : config.hal.emergency_stops) {
    if (other.joint == read.joint && other.input == read.input)
      stop.fail("has the input of " + other.name + ": each emergency stop has an input of its own");
  }
  return read;
}

}  // namespace

void readEmergencyStops(const Reader& top, RtConfig& into) {
  const auto block = top.find("HALInterface");
  const auto stops = block ? block->find("emergency_stops") : std::nullopt;
  if (!stops) return;
  for (const auto& [name, stop] : stops->entries()) {
    if (into.hal.emergency_stops.size() == link::kMaxStops)
      stop.fail("is one too many: at most " + std::to_string(link::kMaxStops) + " emergency stops are read");
    into.hal.emergency_stops.push_back(readStop(name, stop, into));
  }
}

}  // namespace robotui::rt::config
