// The command line of robotui-rt: that of XBot, and what is new.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "robotui/rt/config/plan.h"

namespace robotui::rt::supervisor {

struct Options {
  std::filesystem::path config;
  config::Overrides overrides;          // -D, --period
  config::Communication communication;  // --no-ch, --ch-period
  bool allow_non_rt = false;
  bool nrt = false;      // the same processes in ordinary threads
  bool verbose = false;  // -V
  std::string name;      // --name; empty is the robot's
};

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Nothing where the help was asked for. Throws UsageError with a sentence.
std::optional<Options> parseOptions(int argc, char** argv);

std::string_view usage() noexcept;

// What of it the processes that it starts must know, too.
std::vector<std::string> childArguments(const Options& options);

}  // namespace robotui::rt::supervisor
