// robotui-rt-joints: a joint controller that the HAL `udp` talks to, simulated.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>

#include <getopt.h>

#include "robotui/rt/config/reader.h"
#include "udp/joint_server.h"

namespace {

namespace udp = robotui::rt::hal::udp;
namespace config = robotui::rt::config;

volatile std::sig_atomic_t ended = 0;
volatile std::sig_atomic_t opened = 0;  // the circuits of all emergency stops

constexpr const char* kUsage =
    "robotui-rt-joints -C CONFIG [--address IP] [--port PORT] [--watchdog-ms MS] [--posture NAME]\n"
    "Simulates the joint controller of the robot that CONFIG describes, for a HAL of type udp, at the port where that "
    "looks for it. SIGUSR1 opens the circuits of all emergency stops, SIGUSR2 closes them.\n";

struct Arguments {
  std::string config;
  std::optional<std::uint16_t> port;
  udp::JointServerSettings settings;
};

Arguments parse(int argc, char** argv) {
  const option known[] = {
      {"config", required_argument, nullptr, 'C'},      {"address", required_argument, nullptr, 'a'},
      {"port", required_argument, nullptr, 'p'},        {"posture", required_argument, nullptr, 'o'},
      {"watchdog-ms", required_argument, nullptr, 'w'}, {nullptr, 0, nullptr, 0}};
  Arguments arguments;
  for (int key; (key = ::getopt_long(argc, argv, "C:", known, nullptr)) != -1;) {
    switch (key) {
      case 'C': arguments.config = optarg; break;
      case 'a': arguments.settings.address = optarg; break;
      case 'p': arguments.port = static_cast<std::uint16_t>(std::stoul(optarg)); break;
      case 'o': arguments.settings.posture = optarg; break;
      case 'w': arguments.settings.watchdog_ns = std::stoll(optarg) * 1'000'000; break;
      default: throw std::runtime_error(kUsage);
    }
  }
  if (arguments.config.empty()) throw std::runtime_error(kUsage);
  return arguments;
}

std::uint16_t portOf(const config::HalConfig& hal, std::uint16_t otherwise) {
  if (hal.type != "udp") return otherwise;
  const config::Reader params(hal.params, hal.place.file, "HALInterface.params", hal.place);
  return static_cast<std::uint16_t>(params.wholeOr("port", otherwise, 1, 65535));
}

void serve(Arguments arguments) {
  const config::RtConfig loaded = config::load(arguments.config, {});
  arguments.settings.port = arguments.port.value_or(portOf(loaded.hal, arguments.settings.port));
  udp::JointServer server(loaded.robot, arguments.settings);
  std::cout << "port " << server.port() << std::endl;
  while (ended == 0) {
    server.wire(opened != 0 ? 0 : 0xffff);
    server.step();
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGTERM, [](int) { ended = 1; });
  std::signal(SIGINT, [](int) { ended = 1; });
  std::signal(SIGUSR1, [](int) { opened = 1; });
  std::signal(SIGUSR2, [](int) { opened = 0; });
  try {
    serve(parse(argc, argv));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
