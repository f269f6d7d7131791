#include "robotui/rt/hal/kinds.h"

#include "canopen/canopen.h"
#include "dummy/dummy.h"
#include "library.h"
#include "udp/udp.h"

namespace robotui::rt::hal {

namespace {

// Kinds that are libraries of their own, and what was missing where they were not built.
struct Optional {
  std::string_view type;
  const char* remedy;
};

constexpr Optional kOptional[] = {
    {"mujoco", "build it again where MuJoCo is (-DMUJOCO_ROOT=FOLDER), or take another type"},
    {"gazebo", "install libignition-transport-dev and libignition-msgs-dev and build it again, or take another type"}};

// Beside this program, as it was built or installed; empty where it was not built.
std::filesystem::path libraryOf(std::string_view type) {
  std::error_code ignored;
  const std::string name = "librobotui_rt_hal_" + std::string(type) + ".so";
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& file :
       {folder / name, folder.parent_path() / "lib" / name, folder.parent_path() / "lib" / "robotui-rt" / name}) {
    if (std::filesystem::exists(file, ignored)) return file;
  }
  return {};
}

}  // namespace

std::unique_ptr<Hal> create(const config::HalConfig& config) {
  if (config.type == "dummy") return std::make_unique<Dummy>();
  if (config.type == "udp") return std::make_unique<udp::Udp>();
  if (config.type == "canopen") return std::make_unique<canopen::CanOpen>();
  if (config.type == "library") return loadLibrary(config.lib_file);
  std::string remedy = "take another type, or lib_file with a HAL of your own";
  for (const Optional& kind : kOptional) {
    if (config.type != kind.type) continue;
    if (const std::filesystem::path file = libraryOf(kind.type); !file.empty()) return loadLibrary(file);
    remedy = kind.remedy;
  }
  throw config::ConfigError(config.place, "The HAL '" + config.type + "' is not built in: " + remedy + ".");
}

}  // namespace robotui::rt::hal
