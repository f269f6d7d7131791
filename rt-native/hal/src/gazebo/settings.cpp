#include "settings.h"

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/clock.h"
#include "topics.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::int64_t kTimeoutUs = 200'000;

AtEnd readEnd(const config::Reader& params) {
  const auto asked = params.find("at_end");
  if (!asked) return AtEnd::kHold;
  const std::string word = asked->oneOf({"hold", "pause", "leave"});
  return word == "hold" ? AtEnd::kHold : word == "pause" ? AtEnd::kPause : AtEnd::kLeave;
}

// A name is one part of a topic.
std::string readName(const config::Reader& params, std::string_view key, const std::string& otherwise) {
  const auto asked = params.find(key);
  std::string name = asked ? asked->text() : otherwise;
  if (asked && (!isTopic("/" + name) || name.find('/') != std::string::npos))
    asked->fail("is '" + name + "', which cannot be a part of a topic: write the name as it stands in the world's SDF");
  return name;
}

// Where there is more than one, each needs a topic of its own.
void readPattern(const config::Reader& topics, std::string_view key, std::initializer_list<std::string_view> places,
                 std::size_t count, std::string& pattern) {
  const auto asked = topics.find(key);
  if (!asked) return;
  pattern = asked->text();
  if (const std::string wrong = patternFault(pattern, places, count > 1); !wrong.empty()) asked->fail(wrong);
}

void readTopics(const config::Reader& params, const config::RobotDescription& robot, TopicPatterns& into) {
  const auto topics = params.find("topics");
  if (!topics) return;
  topics->knowsOnly({"joint_state", "position", "velocity", "effort", "imu", "force_torque", "statistics", "control"});
  readPattern(*topics, "joint_state", {}, 1, into.joint_state);
  readPattern(*topics, "position", {"joint"}, robot.joints.size(), into.position);
  readPattern(*topics, "velocity", {"joint"}, robot.joints.size(), into.velocity);
  readPattern(*topics, "effort", {"joint"}, robot.joints.size(), into.effort);
  readPattern(*topics, "imu", {"sensor", "link"}, robot.imus.size(), into.imu);
  readPattern(*topics, "force_torque", {"sensor", "link"}, robot.force_torques.size(), into.force_torque);
  readPattern(*topics, "statistics", {}, 1, into.statistics);
  readPattern(*topics, "control", {}, 1, into.control);
}

}  // namespace

Settings readSettings(const config::HalConfig& config, const config::RobotDescription& robot) {
  const config::Reader params(config.params, config.place.file, "HALInterface.params", config.place);
  params.knowsOnly({"world", "model", "partition", "address", "timeout_us", "at_end", "topics"});
  Settings settings;
  settings.world = readName(params, "world", settings.world);
  settings.model = readName(params, "model", robot.name);
  settings.partition = params.textOr("partition", "");
  settings.address = params.textOr("address", settings.address);
  settings.timeout_ns = params.wholeOr("timeout_us", kTimeoutUs, 1000, 10'000'000) * link::kMicrosecond;
  settings.at_end = readEnd(params);
  readTopics(params, robot, settings.topics);
  return settings;
}

}  // namespace robotui::rt::hal::gazebo
