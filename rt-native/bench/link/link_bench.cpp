// What writing and reading the link costs, by number of joints. All is in the caches here: in a cycle of a millisecond
// it costs more.
#include <benchmark/benchmark.h>

#include <memory>

#include "robotui/rt/link/command.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::link {
namespace {

Counts countsOf(const benchmark::State& state) { return {static_cast<std::uint32_t>(state.range(0)), 1, 2}; }

struct Ring {
  explicit Ring(const Counts& counts) : writer(*segment, counts) {}
  void publish() noexcept {
    ++frame->cycle;
    writer.publish(*frame);
  }
  Segment<StateSegment> segment = Segment<StateSegment>::create(1);
  StateWriter writer;
  std::unique_ptr<FrameData> frame = std::make_unique<FrameData>();
};

void publish(benchmark::State& state) {
  Ring ring(countsOf(state));
  for (auto _ : state) ring.publish();
}

// The system call that wakes readers, of whom there are none here.
void publishAndRing(benchmark::State& state) {
  Ring ring(countsOf(state));
  for (auto _ : state) {
    ring.publish();
    ring.writer.ring();
  }
}

// Each reader is a new one, to which any frame is new.
void read(benchmark::State& state) {
  Ring ring(countsOf(state));
  ring.publish();
  auto into = std::make_unique<FrameData>();
  for (auto _ : state) {
    StateReader reader(*ring.segment);
    benchmark::DoNotOptimize(reader.newest(*into));
    benchmark::ClobberMemory();
  }
}

void command(benchmark::State& state) {
  const auto segment = Segment<HostSegment>::create(1);
  SlotWriter writer(*segment, 0, static_cast<std::uint32_t>(state.range(0)));
  const auto commands = std::make_unique<CommandData>();
  for (auto _ : state) writer.write(*commands);
}

BENCHMARK(publish)->Arg(7)->Arg(40)->Arg(60);
BENCHMARK(publishAndRing)->Name("publish_and_ring")->Arg(40);
BENCHMARK(read)->Arg(7)->Arg(40)->Arg(60);
BENCHMARK(command)->Arg(40);

}  // namespace
}  // namespace robotui::rt::link
