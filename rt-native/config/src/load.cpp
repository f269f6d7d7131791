#include "blocks.h"
#include "describe.h"

namespace robotui::rt::config {
namespace {

void warn(const Reader& at, const std::string& what, std::vector<std::string>& warnings) {
  warnings.emplace_back(ConfigError(at.place(), at.path() + " " + what).what());
}

// A block or key by its name, or by the older one, which is taken with a warning.
std::optional<Reader> findEither(const Reader& in, std::string_view name, std::string_view older,
                                 std::vector<std::string>& warnings) {
  const auto found = in.find(name);
  const auto old = in.find(older);
  if (old)
    warn(*old,
         found ? "is the older name of '" + std::string(name) + "', which is there, too: it has no effect"
               : "is an older name; write '" + std::string(name) + "'",
         warnings);
  return found ? found : old;
}

RobotFile fileOf(const Reader& value) {
  const std::filesystem::path path = value.text();
  const auto folder = value.place().file.parent_path();
  return {path.is_absolute() ? path : (folder / path).lexically_normal(), value.place()};
}

constexpr const char* kInterfaceExample =
    "XBotInterface: {urdf_path: robot.urdf, srdf_path: robot.srdf, joint_map_path: joint_map.yaml}";

RobotFiles readFiles(const Reader& top, std::vector<std::string>& warnings) {
  const auto block = findEither(top, "XBotInterface", "x_bot_interface", warnings);
  if (!block) top.at("XBotInterface", kInterfaceExample);
  block->knows({"urdf_path", "srdf_path", "joint_map_path", "joint_map_config"}, warnings);
  RobotFiles files;
  files.urdf = fileOf(block->at("urdf_path", "urdf_path: robot.urdf"));
  if (const auto srdf = block->find("srdf_path")) files.srdf = fileOf(*srdf);
  const auto map = findEither(*block, "joint_map_path", "joint_map_config", warnings);
  files.joint_map = fileOf(map ? *map : block->at("joint_map_path", "joint_map_path: joint_map.yaml"));
  return files;
}

std::string readModelType(const Reader& block, std::vector<std::string>& warnings) {
  const auto type = block.find("model_type");
  if (!type) return "KDL";
  if (type->text() == "RBDL") {
    warn(*type, "is RBDL, which is not built in: KDL computes the same", warnings);
    return "KDL";
  }
  return type->oneOf({"KDL", "MUJOCO"});
}

// And the robot, which its settings say how to read.
void readModel(const Reader& top, const RobotFiles& files, RtConfig& config) {
  config.model_type = "KDL";
  bool floating_base = false;
  auto inertia = NegativeInertia::kRefuse;
  if (const auto block = top.find("ModelInterface")) {
    block->knows({"model_type", "is_model_floating_base", "negative_inertia"}, config.warnings);
    config.model_type = readModelType(*block, config.warnings);
    floating_base = block->flagOr("is_model_floating_base", false);
    const auto negative = block->find("negative_inertia");
    if (negative && negative->oneOf({"refuse", "keep"}) == "keep") inertia = NegativeInertia::kKeep;
  }
  const auto limits = top.find("JointLimits");
  config.robot =
      describe(files, limits ? JointLimits(*limits) : JointLimits(), floating_base, inertia, config.warnings);
}

void readMaster(const Reader& top, RtConfig& config) {
  config.master = "robotui";
  const auto block = top.find("MasterCommunicationInterface");
  if (!block) return;
  block->knows({"framework_name", "enable_ref_read"}, config.warnings);
  if (const auto name = block->find("framework_name"))
    config.master = name->text() == "ros" ? "ROS" : name->oneOf({"ROS", "robotui"});
  config.enable_ref_read = block->flagOr("enable_ref_read", config.enable_ref_read);
}

void readOthers(const Reader& top, RtConfig& config) {
  if (const auto name = top.find("RobotName")) config.robot.name = name->text();
  if (const auto block = top.find("RobotInterface")) block->knows({"framework_name"}, config.warnings);
  if (const auto block = top.find("SimulationOptions"))
    warn(*block, "has no effect: the simulation's settings are HALInterface.params", config.warnings);
}

}  // namespace

RtConfig load(const std::filesystem::path& file, const Overrides& overrides) {
  RtConfig config;
  config.file = std::filesystem::absolute(file);
  const Reader top = readYamlFile(config.file, {}, "the configuration");
  top.knows({"XBotInterface", "x_bot_interface", "RobotInterface", "ModelInterface", "MasterCommunicationInterface",
             "XBotRTPlugins", "NRTPlugins", "HALInterface", "RobotName", "SimulationOptions", "xbotcore_threads",
             "xbotcore_plugins", "switch_groups", "JointLimits"},
            config.warnings);
  const RobotFiles files = readFiles(top, config.warnings);
  readModel(top, files, config);
  readMaster(top, config);
  readOthers(top, config);
  config.hal = readHal(top, overrides, config.warnings);
  readFollowing(top, config);
  readEmergencyStops(top, config);
  config.threads = readThreads(top, config.hal, overrides, config.warnings);
  readPlugins(top, config);
  readSwitchGroups(top, config);
  checkLimits(top, config);
  return config;
}

}  // namespace robotui::rt::config
