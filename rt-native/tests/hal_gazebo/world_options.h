// What a model of a world is, without the headers of the transport, which take long to compile.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace robotui::rt::hal::gazebo {

struct WorldOptions {
  std::string partition;
  std::string world = "default";
  std::string model = "arm";
  std::vector<std::string> joints;
  std::string controllers = "pve";
  std::string imu;  // topics; empty is none
  std::string force_torque;
  bool paused = false;
  bool strange = false;  // another program that sends numbers where states are expected
};

// Lets it run by the clock until the input ends; each of its lines is a command, each line of the output an answer.
void runWorld(const WorldOptions& options, std::istream& input, std::ostream& output);

}  // namespace robotui::rt::hal::gazebo
