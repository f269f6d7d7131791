#include <algorithm>
#include <limits>

#include "blocks.h"

namespace robotui::rt::config {
namespace {

constexpr double kTurning = 0.5;  // rad: far more than a drive gives way, and far less than a fall
constexpr double kSliding = 0.1;  // m
constexpr double kMost = 100;
constexpr std::string_view kAll = "default";

// Zero is no limit.
double limitOf(const Reader& value) {
  const double limit = value.real(0, kMost);
  return limit > 0 ? limit : std::numeric_limits<double>::infinity();
}

void takeJoint(const std::string& name, const Reader& value, RtConfig& into) {
  const auto& joints = into.robot.joints;
  const auto joint = std::find_if(joints.begin(), joints.end(), [&](const auto& each) { return each.name == name; });
  if (joint == joints.end()) {
    std::vector<std::string> known{std::string(kAll)};
    for (const JointDescription& each : joints) known.push_back(each.name);
    value.fail("is the limit of a joint that is not in the joint map" + didYouMean(name, known));
  }
  into.hal.following_errors[static_cast<std::size_t>(joint - joints.begin())] = limitOf(value);
}

// One number for all joints, or a map with `default` and joints.
void takeLimits(const Reader& limits, RtConfig& into) {
  const bool is_map = limits.node().IsMap();
  const auto all = is_map ? limits.find(kAll) : std::optional(limits);
  if (all) std::fill(into.hal.following_errors.begin(), into.hal.following_errors.end(), limitOf(*all));
  if (!is_map) return;
  for (const auto& [name, value] : limits.entries()) {
    if (name != kAll) takeJoint(name, value, into);
  }
}

}  // namespace

void readFollowing(const Reader& top, RtConfig& into) {
  into.hal.following_errors.clear();
  for (const JointDescription& joint : into.robot.joints) {
    into.hal.following_errors.push_back(joint.type == JointType::kPrismatic ? kSliding : kTurning);
  }
  const auto block = top.find("HALInterface");
  if (!block) return;
  if (const auto limits = block->find("following_error")) takeLimits(*limits, into);
  into.hal.following_time = block->realOr("following_time", into.hal.following_time, 0.001, 60);
}

}  // namespace robotui::rt::config
