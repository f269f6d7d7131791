#include "robotui/rt/hal/kinds.h"

#include "dummy/dummy.h"
#include "library.h"
#include "udp/udp.h"

namespace robotui::rt::hal {

namespace {

constexpr const char* kMujoco = "librobotui_rt_hal_mujoco.so";

// Beside this program, as it was built or installed; empty where it was not built.
std::filesystem::path mujocoLibrary() {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& file : {folder / kMujoco, folder.parent_path() / "lib" / kMujoco,
                           folder.parent_path() / "lib" / "robotui-rt" / kMujoco}) {
    if (std::filesystem::exists(file, ignored)) return file;
  }
  return {};
}

}  // namespace

std::unique_ptr<Hal> create(const config::HalConfig& config) {
  if (config.type == "dummy") return std::make_unique<Dummy>();
  if (config.type == "udp") return std::make_unique<udp::Udp>();
  if (config.type == "library") return loadLibrary(config.lib_file);
  if (const std::filesystem::path file = mujocoLibrary(); config.type == "mujoco" && !file.empty())
    return loadLibrary(file);
  throw config::ConfigError(
      config.place,
      "The HAL '" + config.type + "' is not built in: take another type, or lib_file with a HAL of your own.");
}

}  // namespace robotui::rt::hal
