#include "settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr const char* kDriveExample = "{node: 3, counts_per_radian: 10430.378}";
constexpr const char* kObjectExample = "[0x6065, 0, u32, 5000]";
constexpr double kMostCounts = 2'147'483'647.0;
constexpr std::int64_t kFrameBits = 135;  // 8 bytes, stuffed as badly as can be, and the space behind

std::optional<long long> numberIn(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty()) return {};
  return negative ? -value : value;
}

long long readNumber(const config::Reader& from, long long least, long long most) {
  const auto value = numberIn(from.text());
  if (!value || *value < least || *value > most)
    from.fail("is '" + from.text() + "'; expected a whole number from " + std::to_string(least) + " to " +
              std::to_string(most) + ", such as 24676 or 0x6064");
  return *value;
}

GivenObject readObject(const config::Reader& from) {
  const auto items = from.items(kObjectExample);
  if (items.size() != 4) from.fail(std::string("needs index, sub-index, type and value, such as ") + kObjectExample);
  GivenObject object{};
  object.object = {static_cast<std::uint16_t>(readNumber(items[0], 0x1000, 0xffff)),
                   static_cast<std::uint8_t>(readNumber(items[1], 0, 255))};
  const std::string type = items[2].oneOf({"i8", "u8", "i16", "u16", "i32", "u32"});
  const int bits = std::stoi(type.substr(1));
  const bool has_sign = type.front() == 'i';
  const long long most = has_sign ? (1LL << (bits - 1)) - 1 : (1LL << bits) - 1;
  object.size = static_cast<std::uint8_t>(bits / 8);
  object.value = static_cast<std::uint32_t>(readNumber(items[3], has_sign ? -most - 1 : 0, most));
  return object;
}

double readCounts(const config::Reader& from, config::JointType type) {
  const bool turns = type == config::JointType::kRevolute;
  const char* const key = turns ? "counts_per_radian" : "counts_per_metre";
  if (const auto other = from.find(turns ? "counts_per_metre" : "counts_per_radian"))
    other->fail(std::string("is not for this joint, which ") + (turns ? "turns" : "slides") + "; write " + key);
  const config::Reader counts = from.at(key, std::string(key) + ": 10430.378");
  const double value = counts.real(-1e10, 1e10);
  if (std::abs(value) < 1e-3)
    counts.fail("is too near to 0: it is counts of the encoder in a turn, times the gear, by 2 pi");
  return value;
}

void checkRange(const config::Reader& from, const DriveSettings& drive) {
  for (const double limit : {drive.lower, drive.upper}) {
    if (std::isfinite(limit) && std::abs((limit - drive.offset) * drive.counts) > kMostCounts)
      from.fail("needs more than 32 bits at the limits of the joint: lower counts_per_radian in the drive, and here");
  }
}

DriveSettings readDrive(const config::Reader& from, const config::JointDescription& joint, const Ways& ways) {
  from.knowsOnly(
      {"node", "counts_per_radian", "counts_per_metre", "offset", "velocity_scale", "rated_torque", "objects"});
  DriveSettings drive;
  drive.joint = joint.name;
  drive.node = static_cast<std::uint8_t>(from.at("node", "node: 3").whole(1, 127));
  drive.counts = readCounts(from, joint.type);
  drive.offset = from.realOr("offset", 0, -1e6, 1e6);
  drive.velocity_scale = from.realOr("velocity_scale", drive.counts, -1e9, 1e9);
  if (drive.velocity_scale == 0)
    from.at("velocity_scale", "velocity_scale: 10430.378")
        .fail("is 0: leave it out, or write units of 0x60FF per rad/s");
  drive.rated_effort = from.realOr("rated_torque", 0, -1e6, 1e6);
  if (ways.effort && drive.rated_effort == 0)
    from.at("rated_torque", "rated_torque: 12, N m at the joint of 1000 in 0x6071").fail("is 0, but modes has effort");
  drive.most_effort = joint.effort;
  drive.lower = joint.lower;
  drive.upper = joint.upper;
  checkRange(from, drive);
  if (const auto objects = from.find("objects"))
    for (const config::Reader& item : objects->items(kObjectExample)) drive.objects.push_back(readObject(item));
  return drive;
}

Ways readWays(const config::Reader& params) {
  const auto modes = params.find("modes");
  if (!modes) return {};
  Ways ways{false, false, false};
  for (const config::Reader& mode : modes->items("[position, velocity]")) {
    const std::string word = mode.oneOf({"position", "velocity", "effort"});
    (word == "position" ? ways.position : word == "velocity" ? ways.velocity : ways.effort) = true;
  }
  if (!ways.position) modes->fail("has no position, by which joints hold where they are; write modes: [position, ...]");
  return ways;
}

void readDrives(const config::Reader& params, const config::RobotDescription& robot, Settings& settings) {
  const config::Reader drives =
      params.at("drives", std::string("drives: {") + robot.joints.front().name + ": " + kDriveExample + "}");
  std::map<int, std::string> nodes{{settings.own_node, "own_node"}};
  for (const config::JointDescription& joint : robot.joints) {
    const config::Reader drive = drives.at(joint.name, joint.name + ": " + kDriveExample);
    settings.drives.push_back(readDrive(drive, joint, settings.ways));
    const auto [other, is_new] = nodes.emplace(settings.drives.back().node, joint.name);
    if (!is_new) drive.fail("has the node of " + other->second + ": each node of a bus has a number of its own");
  }
  std::vector<std::string> names;
  for (const config::JointDescription& joint : robot.joints) names.push_back(joint.name);
  for (const auto& [name, drive] : drives.entries()) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      drive.fail("is no joint of the joint map" + config::didYouMean(name, names));
  }
}

// Its joint is one of the robot's: the configuration was checked.
void wire(const config::EmergencyStop& stop, Settings& settings) {
  for (std::size_t i = 0; i < settings.drives.size(); ++i) {
    if (settings.drives[i].joint != stop.joint) continue;
    settings.drives[i].has_stop = true;
    settings.stops.push_back({i, stop.input, stop.closed});
  }
}

}  // namespace

Ways Settings::waysOf(const DriveSettings& drive) const noexcept {
  Ways all = ways;
  all.inputs = drive.has_stop;
  return all;
}

Settings readSettings(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) {
  const config::Reader params(config.params, config.place.file, "HALInterface.params", config.place);
  params.knowsOnly({"interface", "bitrate", "heartbeat_ms", "heartbeat_timeout_ms", "missed_pdos", "enable_timeout_ms",
                    "sdo_timeout_ms", "own_node", "mapping", "modes", "enable", "drives"});
  Settings settings;
  settings.interface = params.textOr("interface", "can0");
  settings.bitrate = params.wholeOr("bitrate", 1'000'000, 10'000, 8'000'000);
  settings.period_ns = period_ns;
  const long long heartbeat_ms = params.wholeOr("heartbeat_ms", 100, 10, 10'000);
  settings.heartbeat_ns = heartbeat_ms * link::kMillisecond;
  settings.heartbeat_timeout_ns =
      params.wholeOr("heartbeat_timeout_ms", std::min(3 * heartbeat_ms, 65'535LL), heartbeat_ms, 65'535) *
      link::kMillisecond;
  settings.missed_pdos = static_cast<std::uint32_t>(params.wholeOr("missed_pdos", 5, 1, 1000));
  settings.enable_timeout_ns = params.wholeOr("enable_timeout_ms", 3000, 10, 60'000) * link::kMillisecond;
  settings.sdo_timeout_ms = static_cast<int>(params.wholeOr("sdo_timeout_ms", 500, 10, 10'000));
  settings.own_node = static_cast<std::uint8_t>(params.wholeOr("own_node", 127, 1, 127));
  if (const auto mapping = params.find("mapping"))
    settings.writes_mapping = mapping->oneOf({"write", "keep"}) == "write";
  settings.enables = params.flagOr("enable", true);
  settings.ways = readWays(params);
  readDrives(params, robot, settings);
  for (const config::EmergencyStop& stop : config.emergency_stops) wire(stop, settings);
  return settings;
}

double loadOf(const Settings& settings, std::size_t frames) noexcept {
  const double bits = static_cast<double>((static_cast<std::int64_t>(frames) + 1) * kFrameBits);
  return bits / static_cast<double>(settings.bitrate) / (static_cast<double>(settings.period_ns) * 1e-9);
}

}  // namespace robotui::rt::hal::canopen
