// robotui-rt-hal: started by robotui-rt, not by hand.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>

#include <getopt.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "process.h"

namespace {

namespace hal = robotui::rt::hal;
namespace link = robotui::rt::link;

std::atomic<bool> ended{false};

struct Arguments {
  hal::ProcessOptions options;
  int control = -1;
};

Arguments parse(int argc, char** argv) {
  const option known[] = {{"config", required_argument, nullptr, 'C'},
                          {"control", required_argument, nullptr, 'f'},
                          {"dummy", no_argument, nullptr, 'D'},
                          {"period", required_argument, nullptr, 'p'},
                          {"ch-period", required_argument, nullptr, 'c'},
                          {"no-ch", no_argument, nullptr, 'n'},
                          {"allow-non-rt", no_argument, nullptr, 'r'},
                          {"nrt", no_argument, nullptr, 'o'},
                          {nullptr, 0, nullptr, 0}};
  Arguments arguments;
  hal::ProcessOptions& options = arguments.options;
  for (int key; (key = ::getopt_long(argc, argv, "C:D", known, nullptr)) != -1;) {
    switch (key) {
      case 'C': options.config = optarg; break;
      case 'f': arguments.control = std::atoi(optarg); break;
      case 'D': options.overrides.dummy = true; break;
      case 'p': options.overrides.period = std::chrono::microseconds(std::atoll(optarg)); break;
      case 'c': options.communication.period = std::chrono::microseconds(std::atoll(optarg)); break;
      case 'n': options.communication.enabled = false; break;
      case 'r': options.allow_non_rt = true; break;
      case 'o': options.nrt = true; break;
      default: std::exit(2);
    }
  }
  return arguments;
}

// A loop that computes for half a second without a pause is ended by the kernel: nothing below its priority would run
// any more.
void limitProcessor() {
  constexpr rlim_t kSoft = 500'000;  // microseconds
  const rlimit limit{kSoft, 2 * kSoft};
  ::setrlimit(RLIMIT_RTTIME, &limit);
}

int work(const Arguments& arguments) {
  const link::Socket supervisor{link::Descriptor(arguments.control)};
  link::Packet begin;
  if (supervisor.receive(begin, std::chrono::seconds(10)) != link::Received::kPacket || begin.verb() != "begin") {
    std::cerr << "robotui-rt-hal is started by robotui-rt: it cannot run by itself.\n";
    return 2;
  }
  try {
    hal::Process process(arguments.options, std::move(begin));
    for (const std::string& warning : process.warnings()) supervisor.send("log warn " + warning);
    const link::Descriptor state = process.shareState();
    const int given[] = {state.get()};
    supervisor.send("state", given);
    process.obey(supervisor, ended);
    return 0;
  } catch (const std::exception& error) {
    supervisor.send(std::string("failed ") + error.what());
    return 1;
  }
}

}  // namespace

// The terminal's interrupt goes to the whole group, but the supervisor ends its children in order.
int main(int argc, char** argv) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, [](int) { ended = true; });
  const Arguments arguments = parse(argc, argv);
  limitProcessor();
  return work(arguments);
}
