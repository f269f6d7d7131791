// robotui-rt-drives: the drives that the HAL `canopen` talks to, simulated.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include <getopt.h>

#include "canopen/settings.h"
#include "canopen/simulated/simulated_bus.h"

namespace {

namespace canopen = robotui::rt::hal::canopen;
namespace config = robotui::rt::config;

volatile std::sig_atomic_t ended = 0;

constexpr const char* kUsage =
    "robotui-rt-drives -C CONFIG [--interface unix:PATH]\n"
    "Simulates the drives that the HAL canopen of CONFIG talks to, on the bus that CONFIG names.\n";

struct Arguments {
  std::string config;
  std::optional<std::string> interface;
};

Arguments parse(int argc, char** argv) {
  const option known[] = {{"config", required_argument, nullptr, 'C'},
                          {"interface", required_argument, nullptr, 'i'},
                          {nullptr, 0, nullptr, 0}};
  Arguments arguments;
  for (int key; (key = ::getopt_long(argc, argv, "C:", known, nullptr)) != -1;) {
    switch (key) {
      case 'C': arguments.config = optarg; break;
      case 'i': arguments.interface = optarg; break;
      default: throw std::runtime_error(kUsage);
    }
  }
  if (arguments.config.empty()) throw std::runtime_error(kUsage);
  return arguments;
}

// At zero of the joint, or at the limit that is nearest to it.
double firstCounts(const canopen::DriveSettings& drive) {
  const double position = std::min(std::max(0.0, drive.lower), drive.upper);
  return (position - drive.offset) * drive.counts;
}

void serve(const Arguments& arguments) {
  const config::RtConfig loaded = config::load(arguments.config, {});
  if (loaded.hal.type != "canopen")
    throw config::ConfigError(loaded.hal.place, "HALInterface.type is '" + loaded.hal.type + "'; expected canopen");
  const canopen::Settings settings =
      canopen::readSettings(loaded.robot, loaded.hal, std::chrono::nanoseconds(loaded.hal.period).count());
  const std::string interface = arguments.interface.value_or(settings.interface);
  canopen::simulated::SimulatedBus bus(interface);
  for (const canopen::DriveSettings& drive : settings.drives) bus.add(drive.node, firstCounts(drive));
  std::cout << "drives " << bus.drives() << " on " << interface << std::endl;
  while (ended == 0) bus.step(1);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGTERM, [](int) { ended = 1; });
  std::signal(SIGINT, [](int) { ended = 1; });
  try {
    serve(parse(argc, argv));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
