// A first configuration of a robot of which there is a URDF: what ./robotui new robot writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

struct DraftFile {
  std::string name;  // in the folder
  std::string text;
};

// What would be written, and what a user should know of it.
struct Draft {
  std::string robot;
  std::string posture;  // to which Homing moves
  std::vector<DraftFile> files;
  std::vector<std::string> chosen;    // sentences
  std::vector<std::string> left_out;  // sentences
};

// Reads the robot and chooses; writes nothing. An empty `srdf` is none. `folder` is where the files are to lie. Throws
// ConfigError.
Draft draftOf(const std::filesystem::path& urdf, const std::filesystem::path& srdf,
              const std::filesystem::path& folder);

// Writes all files, of which none may be there, and makes the folder. Throws ConfigError.
void writeDraft(const Draft& draft, const std::filesystem::path& folder);

}  // namespace robotui::rt::config
