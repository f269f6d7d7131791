// robotui-rt: control of a robot in real time.
#include <algorithm>
#include <iostream>

#include "robotui/rt/supervisor/rights.h"
#include "robotui/rt/supervisor/supervisor.h"

namespace {

namespace config = robotui::rt::config;
namespace link = robotui::rt::link;
using namespace robotui::rt::supervisor;

int highestPriority(const config::RtConfig& config) {
  int highest = config.hal.priority;
  for (const auto& thread : config.threads) {
    highest = std::max(highest, thread.priority);
  }
  return highest;
}

int work(const Options& options) {
  const config::RtConfig config = config::load(options.config, options.overrides);
  const config::Plan plan = config::plan(config, options.communication);
  const std::string name = options.name.empty() ? config.robot.name : options.name;
  ControlServer server(link::socketPath(name));
  LogFile log(logFilePath(name), options.verbose);
  for (const std::string& warning : config.warnings) {
    log.warn(warning);
  }
  const link::Reservation reservation{std::chrono::nanoseconds(config.hal.period).count(), config.hal.runtime};
  const std::string lack = options.nrt ? std::string() : lackOfRights(highestPriority(config), reservation);
  if (!lack.empty() && !options.allow_non_rt) {
    log.error(lack);
    return 3;
  }
  if (options.nrt) {
    log.warn("This is not real time, as it was asked for (--nrt): cycles will come late.");
  } else if (!lack.empty()) {
    log.warn("This process may not run in real time and goes on without (--allow-non-rt): cycles will come late.");
  }
  Supervisor supervisor(options, config, plan, lack.empty() && !options.nrt, server, log);
  log.info("The robot " + name + " listens at " + server.path().string() + ".");
  return supervisor.run();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto options = parseOptions(argc, argv);
    if (!options) {
      std::cout << usage();
      return 0;
    }
    return work(*options);
  } catch (const UsageError& e) {
    std::cerr << "robotui-rt: " << e.what() << "\n\n" << usage();
    return 2;
  } catch (const std::exception& e) {
    std::cerr << "robotui-rt: " << e.what() << "\n";
    return 1;
  }
}
