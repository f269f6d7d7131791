#include "mujoco_settings.h"

#include <algorithm>

#include "robotui/rt/config/reader.h"

namespace robotui::rt::hal {
namespace {

constexpr std::int64_t kLongestStep = 500'000;  // ns; longer ones make stiff drives unstable
constexpr std::int64_t kMostSteps = 100;

int defaultSteps(std::int64_t period_ns) {
  return static_cast<int>(std::clamp<std::int64_t>((period_ns + kLongestStep - 1) / kLongestStep, 1, kMostSteps));
}

std::string readPosture(const config::Reader& params, const config::RobotDescription& robot,
                        const std::string& otherwise) {
  const auto asked = params.find("posture");
  if (!asked) return otherwise;
  std::vector<std::string> names;
  for (const auto& posture : robot.postures) names.push_back(posture.name);
  std::string name = asked->text();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    asked->fail("is '" + name + "', but the SRDF has no such group_state" + config::didYouMean(name, names));
  }
  return name;
}

}  // namespace

MujocoSettings readMujocoSettings(const config::HalConfig& config, const config::RobotDescription& robot,
                                  std::int64_t period_ns) {
  const config::Reader params(config.params, config.place.file, "HALInterface.params", config.place);
  params.knowsOnly({"steps", "floor", "fix_base", "base_height", "posture", "drive_stiffness", "drive_damping",
                    "armature", "ignore_meshes"});
  MujocoSettings settings;
  settings.steps = static_cast<int>(params.wholeOr("steps", defaultSteps(period_ns), 1, kMostSteps));
  settings.floor = params.flagOr("floor", settings.floor);
  settings.ignore_meshes = params.flagOr("ignore_meshes", settings.ignore_meshes);
  settings.fix_base = params.flagOr("fix_base", settings.fix_base);
  settings.base_height = params.realOr("base_height", settings.base_height, -1, 100);
  settings.posture = readPosture(params, robot, settings.posture);
  settings.drive_stiffness = params.realOr("drive_stiffness", settings.drive_stiffness, 0, 1000);
  settings.drive_damping = params.realOr("drive_damping", settings.drive_damping, 0, 10);
  settings.armature = params.realOr("armature", settings.armature, 0, 1);
  return settings;
}

}  // namespace robotui::rt::hal
