// The model of a world as a program: its options are KEY=VALUE, each line of its input is a command, each answer a
// line.
#include "world_options.h"

#include <iostream>
#include <sstream>

#include <sys/prctl.h>
#include <csignal>

namespace {

using robotui::rt::hal::gazebo::WorldOptions;

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream from(text);
  for (std::string part; std::getline(from, part, ',');) parts.push_back(part);
  return parts;
}

WorldOptions parse(int argc, char** argv) {
  WorldOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string key = word.substr(0, word.find('='));
    const std::string value = word.substr(word.find('=') + 1);
    if (key == "partition") options.partition = value;
    if (key == "world") options.world = value;
    if (key == "model") options.model = value;
    if (key == "joints") options.joints = splitAtCommas(value);
    if (key == "controllers") options.controllers = value;
    if (key == "imu") options.imu = value;
    if (key == "force_torque") options.force_torque = value;
    if (key == "strange") options.strange = true;
    if (key == "paused") options.paused = true;
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  robotui::rt::hal::gazebo::runWorld(parse(argc, argv), std::cin, std::cout);
  return 0;
}
