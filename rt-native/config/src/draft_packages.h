// Where the packages lie whose meshes a URDF names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robotui::rt::config {

struct DraftPackages {
  std::vector<std::string> folders;    // that contain them, absolute
  std::vector<std::string> not_found;  // names
};

// Looks in the folders above the URDF.
DraftPackages draftPackages(const std::filesystem::path& urdf, const std::string& text);

}  // namespace robotui::rt::config
