#include "ctl_trace.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>

#include "cycle_trace.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/command.h"
#include "robotui/rt/link/host_damage.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::supervisor {
namespace {

constexpr link::Client::Milliseconds kReply{5000};
constexpr std::int64_t kPatience = 100 * link::kMillisecond;

// What is read of one thread of a host, again and again.
struct Watched {
  std::size_t number;
  const link::HostSegment* host;
  link::SlotReader slot;
  std::vector<std::uint32_t> plugins;  // in the order in which they are called
  std::vector<std::uint64_t> called;   // how often, when it was looked at last
};

class Onlooker {
 public:
  explicit Onlooker(link::Client& client)
      : client_(client), attachment_(client.attach(kReply)), board_(std::make_unique<link::BoardData>()),
        frame_(std::make_unique<link::FrameData>()), answer_(std::make_unique<link::CommandData>()),
        period_ns_(
            std::max<std::int64_t>(link::relaxedLoad(attachment_.state->loop.period_ns), link::kMillisecond / 10)),
        reader_(*attachment_.state), trace_(period_ns_) {
    link::BoardReader(*attachment_.board).read(*board_);
    for (std::uint32_t host = 0; host < attachment_.hosts.size() && host < board_->hosts; ++host) watch(host);
  }

  // False where the robot went, or its processes were changed: what was seen until then counts.
  bool look(std::int64_t until_ns) {
    while (link::now() < until_ns) {
      if (!reader_.wait(std::min(until_ns, link::now() + kPatience))) continue;
      while (reader_.next(*frame_) == link::Read::kNew) trace_.addCycle(frame_->cycle, frame_->sensed_ns);
      // By then its threads have answered, and not yet to the next one.
      std::this_thread::sleep_for(std::chrono::nanoseconds(period_ns_ / 2));
      for (Watched& thread : threads_) take(thread);
      if (client_.notice(std::chrono::milliseconds(0)) != link::Notice::kNone) return false;
    }
    return true;
  }

  const CycleTrace& trace() const noexcept { return trace_; }
  std::uint64_t lost() const noexcept { return reader_.lost(); }

 private:
  void watch(std::uint32_t index) {
    const link::HostSegment& host = *attachment_.hosts[index];
    if (!link::damageOf(host).empty()) return;
    const std::uint32_t threads = std::min(link::relaxedLoad(host.threads), link::kMaxThreads);
    for (std::uint32_t thread = 0; thread < threads; ++thread) {
      trace_.addThread(std::string(link::view(board_->host[index].name)),
                       std::string(link::view(host.thread_statistics[thread].name)));
      threads_.push_back({threads_.size(), &host, link::SlotReader(host, thread, reader_.counts().joints), {}, {}});
      for (std::uint32_t plugin = 0; plugin < board_->plugins; ++plugin) {
        if (board_->plugin[plugin].host == index && board_->plugin[plugin].thread == thread)
          threads_.back().plugins.push_back(plugin);
      }
      threads_.back().called.resize(threads_.back().plugins.size());
    }
  }

  void take(Watched& thread) {
    if (thread.slot.read(*answer_) != link::Read::kNew) return;
    std::vector<CycleTrace::Phase> phases;
    for (std::size_t i = 0; i < thread.plugins.size(); ++i) {
      const auto& statistics = thread.host->plugins[thread.plugins[i]];
      const std::uint64_t called = link::relaxedLoad(statistics.cycles);
      if (called != std::exchange(thread.called[i], called))
        phases.push_back({std::string(link::view(board_->plugin[thread.plugins[i]].name)),
                          link::relaxedLoad(statistics.last_busy_ns)});
    }
    trace_.addAnswer(thread.number, answer_->cycle, answer_->written_ns, std::move(phases));
  }

  link::Client& client_;
  link::Attachment attachment_;
  std::unique_ptr<link::BoardData> board_;
  std::unique_ptr<link::FrameData> frame_;
  std::unique_ptr<link::CommandData> answer_;
  std::int64_t period_ns_;
  link::StateReader reader_;
  CycleTrace trace_;
  std::vector<Watched> threads_;
};

}  // namespace

int traceCycles(link::Client& client, const std::filesystem::path& file, double seconds) {
  Onlooker onlooker(client);
  const bool is_whole = onlooker.look(link::now() + static_cast<std::int64_t>(seconds * 1e9));
  const CycleTrace& trace = onlooker.trace();
  if (!is_whole) std::cerr << "A process of the robot ended or came: the trace ends there.\n";
  std::ofstream out(file);
  trace.write(out);
  if (!out.flush()) throw std::runtime_error("The trace cannot be written to " + file.string() + ".");
  std::cout << file.string() << " has " << trace.cycles() << " cycles and " << trace.answers() << " answers to them; "
            << onlooker.lost() << " cycles were not seen. Open it in ui.perfetto.dev or chrome://tracing.\n";
  return trace.cycles() > 0 ? 0 : 1;
}

}  // namespace robotui::rt::supervisor
