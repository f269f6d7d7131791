// A HAL of the user's own, from a library.
#pragma once

#include <filesystem>
#include <memory>

#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

// Throws std::runtime_error: not there, no HAL, or made for another version.
std::unique_ptr<Hal> loadLibrary(const std::filesystem::path& file);

}  // namespace robotui::rt::hal
