// robotui-rt-new: a first configuration of a robot from its URDF. ./robotui new robot calls it.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "robotui/rt/config/draft.h"

namespace {

namespace config = robotui::rt::config;
namespace fs = std::filesystem;

constexpr const char* kUsage = R"(robotui-rt-new URDF [SRDF] [--in FOLDER]
  Writes a configuration of the control of a robot: joint map, groups, limits, homing, for a kinematic simulation
  and for MuJoCo. FOLDER is the robot's name where it is left out. Ends with 0 where it is written, 1 where it is not.
)";

int write(const fs::path& urdf, const fs::path& srdf, fs::path folder) {
  if (folder.empty()) folder = config::draftOf(urdf, srdf, ".").robot;  // its name is known only then
  const config::Draft draft = config::draftOf(urdf, srdf, folder);
  config::writeDraft(draft, folder);
  config::load(folder / "rt-dummy.yaml", {});  // what is wrong with it is told now
  std::cout << "The robot " << draft.robot << " is in " << folder.string() << ":\n";
  for (const std::string& sentence : draft.chosen) std::cout << "  " << sentence << '\n';
  for (const std::string& sentence : draft.left_out) std::cout << "  Left out: " << sentence << ".\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files;
  std::string folder;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--in" && i + 1 < argc)
      folder = argv[++i];
    else if (word.starts_with("-"))
      files.resize(3);
    else
      files.push_back(word);
  }
  if (files.empty() || files.size() > 2) {
    std::cerr << kUsage;
    return 2;
  }
  try {
    return write(files[0], files.size() > 1 ? files[1] : std::string(), folder);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
