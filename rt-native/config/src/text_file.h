// Whole text files, none larger than can be meant.
#pragma once

#include <cstddef>
#include <string>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

inline constexpr std::size_t kLargestYaml = std::size_t{1} << 20;
inline constexpr std::size_t kLargestXml = std::size_t{16} << 20;

// `wanted` says where the file was asked for; `what` names it, such as "the URDF".
std::string readTextFile(const std::filesystem::path& file, const Place& wanted, const std::string& what,
                         std::size_t largest);

}  // namespace robotui::rt::config
