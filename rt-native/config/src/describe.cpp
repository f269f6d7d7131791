#include "describe.h"

#include "joint_map.h"
#include "srdf.h"
#include "text_file.h"
#include "urdf.h"

namespace robotui::rt::config {

RobotDescription describe(const RobotFiles& files, const JointLimits& limits, bool floating_base,
                          NegativeInertia inertia, std::vector<std::string>& warnings) {
  RobotDescription robot{};
  robot.urdf = readTextFile(files.urdf.file, files.urdf.wanted, "the URDF", kLargestXml);
  const Urdf urdf(files.urdf.file, robot.urdf, inertia);
  warnings.insert(warnings.end(), urdf.warnings().begin(), urdf.warnings().end());
  robot.name = urdf.name();
  robot.floating_base = floating_base;
  robot.joints = readJointMap(files.joint_map.file, files.joint_map.wanted, urdf, limits);
  if (!files.srdf.file.empty()) {
    robot.srdf = readTextFile(files.srdf.file, files.srdf.wanted, "the SRDF", kLargestXml);
    readSrdf(files.srdf.file, robot.srdf, urdf, robot, warnings);
  }
  return robot;
}

RobotDescription describe(const std::filesystem::path& urdf, const std::filesystem::path& srdf,
                          const std::filesystem::path& joint_map, bool floating_base) {
  std::vector<std::string> warnings;
  return describe(RobotFiles{{urdf, {}}, {srdf, {}}, {joint_map, {}}}, {}, floating_base, NegativeInertia::kRefuse,
                  warnings);
}

}  // namespace robotui::rt::config
