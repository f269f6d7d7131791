#include "robotui/rt/supervisor/options.h"

#include <getopt.h>

#include <charconv>
#include <cstring>

namespace robotui::rt::supervisor {
namespace {

constexpr std::string_view kUsage = R"(robotui-rt -C CONFIG [options]: control of a robot's joints in real time
  -C, --config FILE    the robot and its plugins
  -D, --dummy          a kinematic simulation in place of the robot's hardware
      --period US      period of the HAL, microseconds (default: the configuration's, or 1000)
      --ch-period US   period of the communication handler, microseconds (default 5000)
      --no-ch          without communication handler: no IO plugins, no references of a master
      --allow-non-rt   go on without real-time rights
      --nrt            in ordinary threads, also where real time is allowed
      --name NAME      how clients find it (default: the robot's name)
  -V, --verbose        say more
  -h, --help           this text
)";

constexpr option kKnown[] = {{"config", required_argument, nullptr, 'C'},
                             {"dummy", no_argument, nullptr, 'D'},
                             {"period", required_argument, nullptr, 'p'},
                             {"ch-period", required_argument, nullptr, 'c'},
                             {"no-ch", no_argument, nullptr, 'n'},
                             {"allow-non-rt", no_argument, nullptr, 'a'},
                             {"nrt", no_argument, nullptr, 'o'},
                             {"name", required_argument, nullptr, 'N'},
                             {"verbose", no_argument, nullptr, 'V'},
                             {"help", no_argument, nullptr, 'h'},
                             {nullptr, 0, nullptr, 0}};

std::chrono::microseconds period(const char* option, const char* text, long long least, long long most) {
  long long us = 0;
  const char* end = text + std::strlen(text);
  const auto [behind, error] = std::from_chars(text, end, us);
  if (error != std::errc() || behind != end || us < least || us > most) {
    throw UsageError(std::string(option) + " needs a number of microseconds from " + std::to_string(least) + " to " +
                     std::to_string(most) + ", not '" + text + "'.");
  }
  return std::chrono::microseconds(us);
}

void apply(int key, Options& options) {
  switch (key) {
    case 'C': options.config = optarg; break;
    case 'D': options.overrides.dummy = true; break;
    case 'p': options.overrides.period = period("--period", optarg, 100, 1'000'000); break;
    case 'c': options.communication.period = period("--ch-period", optarg, 500, 1'000'000); break;
    case 'n': options.communication.enabled = false; break;
    case 'a': options.allow_non_rt = true; break;
    case 'o': options.nrt = true; break;
    case 'N': options.name = optarg; break;
    case 'V': options.verbose = true; break;
    default: throw UsageError("An option is not known, or lacks its value.");
  }
}

}  // namespace

std::optional<Options> parseOptions(int argc, char** argv) {
  Options options;
  optind = 0;
  opterr = 0;
  for (int key = 0; (key = getopt_long(argc, argv, "C:DVh", kKnown, nullptr)) != -1;) {
    if (key == 'h') {
      return std::nullopt;
    }
    apply(key, options);
  }
  if (optind < argc) {
    throw UsageError("'" + std::string(argv[optind]) + "' is too much.");
  }
  if (options.config.empty()) {
    throw UsageError("A configuration is needed: robotui-rt -C FILE.");
  }
  options.config = std::filesystem::absolute(options.config);
  return options;
}

std::string_view usage() noexcept { return kUsage; }

std::vector<std::string> childArguments(const Options& options) {
  std::vector<std::string> arguments{"--config", options.config.string()};
  if (options.overrides.dummy) {
    arguments.emplace_back("--dummy");
  }
  if (options.overrides.period) {
    arguments.insert(arguments.end(), {"--period", std::to_string(options.overrides.period->count())});
  }
  arguments.insert(arguments.end(), {"--ch-period", std::to_string(options.communication.period.count())});
  if (!options.communication.enabled) {
    arguments.emplace_back("--no-ch");
  }
  return arguments;
}

}  // namespace robotui::rt::supervisor
