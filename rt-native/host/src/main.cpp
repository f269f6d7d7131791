// robotui-rt-host: started by robotui-rt, not by hand.
#include <getopt.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

#include "robotui/rt/host/host.h"
#include "robotui/rt/link/locked_memory.h"

namespace {

using robotui::rt::host::Host;
using robotui::rt::host::HostOptions;
namespace link = robotui::rt::link;

struct Arguments {
  HostOptions options;
  int control = -1;
};

Arguments parse(int argc, char** argv) {
  const option known[] = {{"config", required_argument, nullptr, 'C'}, {"control", required_argument, nullptr, 'f'},
                          {"host", required_argument, nullptr, 'h'},   {"dummy", no_argument, nullptr, 'D'},
                          {"period", required_argument, nullptr, 'p'}, {"ch-period", required_argument, nullptr, 'c'},
                          {"no-ch", no_argument, nullptr, 'n'},        {nullptr, 0, nullptr, 0}};
  Arguments arguments;
  auto& options = arguments.options;
  for (int key = 0; (key = getopt_long(argc, argv, "C:D", known, nullptr)) != -1;) {
    switch (key) {
      case 'C': options.config = optarg; break;
      case 'f': arguments.control = std::atoi(optarg); break;
      case 'h': options.host = static_cast<std::uint32_t>(std::atoi(optarg)); break;
      case 'D': options.overrides.dummy = true; break;
      case 'p': options.overrides.period = std::chrono::microseconds(std::atoll(optarg)); break;
      case 'c': options.communication.period = std::chrono::microseconds(std::atoll(optarg)); break;
      case 'n': options.communication.enabled = false; break;
      default: std::exit(2);
    }
  }
  return arguments;
}

// A thread that computes this long without a pause is ended by the kernel, with its process: it must not starve the
// robot's.
void limitProcessor() {
  constexpr rlim_t kSoft = 200'000;  // microseconds
  const rlimit limit{kSoft, 2 * kSoft};
  setrlimit(RLIMIT_RTTIME, &limit);
}

int work(Arguments arguments) {
  link::Socket supervisor{link::Descriptor(arguments.control)};
  link::Packet begin;
  if (supervisor.receive(begin, std::chrono::seconds(10)) != link::Received::kPacket || begin.verb() != "begin") {
    std::cerr << "robotui-rt-host is started by robotui-rt: it cannot run by itself.\n";
    return 2;
  }
  try {
    Host host(std::move(arguments.options), supervisor, std::move(begin));
    host.run();
    return 0;
  } catch (const std::exception& e) {
    supervisor.send(std::string("unable ") + e.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // of the terminal: the supervisor ends its children in order
  Arguments arguments = parse(argc, argv);
  limitProcessor();
  link::lockMemory();  // refused without the right: then the supervisor has said so
  return work(std::move(arguments));
}
