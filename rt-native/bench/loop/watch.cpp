// rt_watch NAME: looks at a running robotui-rt. Each line on stdin is answered by one of JSON, or by `error SENTENCE`:
//   start PLUGIN...    starts plugins
//   window SECONDS     what its loops did in that time
//   answers SECONDS    how long after sensing the slowest plugin thread had commanded, ns, in some of the cycles
#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "report.h"
#include "robotui/rt/link/client.h"
#include "robotui/rt/link/command.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/link/state.h"

namespace {

using namespace robotui::rt;
using std::chrono::steady_clock;

constexpr link::Client::Milliseconds kReply{20000};
constexpr std::chrono::milliseconds kRetry{20};
constexpr std::chrono::milliseconds kSample{3};

// It may be starting.
link::Client connect(const std::string& robot) {
  for (const auto until = steady_clock::now() + kReply;;) {
    try {
      return link::Client(robot, kReply);
    } catch (const std::runtime_error&) {
      if (steady_clock::now() > until) throw;
    }
    std::this_thread::sleep_for(kRetry);
  }
}

void start(link::Client& client, std::istream& names) {
  for (std::string name; names >> name;) {
    const link::Reply reply = client.request("switch " + name + " 1", kReply);
    if (!reply.ok) throw std::runtime_error(reply.text);
  }
}

template <class Visit>
void eachThread(const link::Attachment& at, Visit&& visit) {
  for (const auto& host : at.hosts) {
    const std::uint32_t threads = std::min(link::relaxedLoad(host->threads), link::kMaxThreads);
    for (std::uint32_t i = 0; i < threads; ++i) visit(*host, i);
  }
}

struct Snapshot {
  explicit Snapshot(const link::Attachment& at) : loop(link::relaxedCopy(at.state->loop)) {
    eachThread(at, [this](const link::HostSegment& host, std::uint32_t i) {
      busy.push_back(link::relaxedCopy(host.thread_statistics[i].busy));
    });
  }
  link::LoopStatistics loop;
  std::vector<link::Histogram> busy;  // of the plugin threads
};

std::string window(link::Client& client, std::chrono::duration<double> time) {
  const link::Attachment at = client.attach(kReply);
  const Snapshot early(at);
  std::this_thread::sleep_for(time);
  const Snapshot late(at);
  std::string threads;
  for (std::size_t i = 0; i < early.busy.size() && i < late.busy.size(); ++i) {
    threads += (threads.empty() ? "" : ", ") + bench::json(late.busy[i], early.busy[i]);
  }
  return "{" + bench::members(late.loop, early.loop) + ", \"threads\": [" + threads + "]}";
}

// When cycles were sensed: those of the last few milliseconds.
class Sensed {
 public:
  explicit Sensed(const link::StateSegment& state) : reader_(state) {}
  void update() {
    while (reader_.next(*frame_) == link::Read::kNew)
      times_[frame_->cycle % times_.size()] = {frame_->cycle, frame_->sensed_ns};
  }
  // 0 where that is not known.
  std::int64_t at(std::uint64_t cycle) const {
    const Time& time = times_[cycle % times_.size()];
    return time.cycle == cycle ? time.ns : 0;
  }

 private:
  struct Time {
    std::uint64_t cycle;
    std::int64_t ns;
  };
  link::StateReader reader_;
  std::unique_ptr<link::FrameData> frame_ = std::make_unique<link::FrameData>();
  std::array<Time, 64> times_{};
};

// Commands before frames: each frame that was answered is then there.
std::string answers(link::Client& client, std::chrono::duration<double> time) {
  const link::Attachment at = client.attach(kReply);
  const std::uint32_t joints = link::relaxedLoad(at.state->joints);
  Sensed sensed(*at.state);
  std::vector<link::SlotReader> slots;
  eachThread(at, [&](const link::HostSegment& host, std::uint32_t i) { slots.emplace_back(host, i, joints); });
  std::vector<link::CommandData> commands(slots.size());
  std::vector<std::int64_t> slowest;
  for (const auto until = steady_clock::now() + time; steady_clock::now() < until;
       std::this_thread::sleep_for(kSample)) {
    bool together = !slots.empty();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      together = slots[i].read(commands[i]) == link::Read::kNew && together && commands[i].cycle == commands[0].cycle;
    }
    sensed.update();
    if (!together || sensed.at(commands[0].cycle) == 0) continue;
    std::int64_t last = 0;
    for (const auto& command : commands) last = std::max(last, command.written_ns);
    slowest.push_back(last - sensed.at(commands[0].cycle));
  }
  return bench::json(slowest);
}

std::string obey(link::Client& client, const std::string& line) {
  std::istringstream words(line);
  std::string verb;
  words >> verb;
  if (verb == "start") {
    start(client, words);
    return "{}";
  }
  double seconds = 0;
  words >> seconds;
  if (verb == "window") return window(client, std::chrono::duration<double>(seconds));
  if (verb == "answers") return answers(client, std::chrono::duration<double>(seconds));
  throw std::runtime_error("there is no command " + verb);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "rt_watch NAME\n";
    return 2;
  }
  try {
    link::Client client = connect(argv[1]);
    for (std::string line; std::getline(std::cin, line);) std::cout << obey(client, line) << std::endl;
    return 0;
  } catch (const std::exception& e) {
    std::cout << "error " << e.what() << std::endl;
    return 1;
  }
}
