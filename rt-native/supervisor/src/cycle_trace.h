// What happened in some seconds, cycle by cycle, as a file that Perfetto and Chrome show: docs/rt-tracing.md.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace robotui::rt::supervisor {

// All times are nanoseconds of CLOCK_MONOTONIC.
class CycleTrace {
 public:
  struct Phase {
    std::string plugin;
    std::int64_t busy_ns;
  };

  explicit CycleTrace(std::int64_t period_ns) : period_ns_(period_ns) {}

  // A thread of a host; its number from 0, by which its answers are known.
  void addThread(const std::string& host, const std::string& thread) { threads_.push_back({host, thread}); }

  // In the order of the cycles.
  void addCycle(std::uint64_t cycle, std::int64_t sensed_ns) { cycles_.push_back({cycle, sensed_ns}); }

  // To a cycle, of a thread, whose plugins took so long one after the other. One to a cycle that was not seen, or that
  // is older than that, is left out.
  void addAnswer(std::size_t thread, std::uint64_t cycle, std::int64_t written_ns, std::vector<Phase> phases);

  std::size_t cycles() const noexcept { return cycles_.size(); }
  std::size_t answers() const noexcept { return answers_.size(); }

  // JSON of the Trace Event Format.
  void write(std::ostream& out) const;

 private:
  struct Thread {
    std::string host;
    std::string name;
  };
  struct Sensed {
    std::uint64_t cycle;
    std::int64_t at_ns;
  };
  struct Answer {
    std::size_t thread;
    std::uint64_t cycle;
    std::int64_t sensed_ns;
    std::int64_t written_ns;
    std::vector<Phase> phases;
  };
  class Events;

  std::vector<std::int64_t> lateness() const;
  void writeNames(Events& events) const;
  void writeCycles(Events& events) const;
  void writeAnswer(Events& events, const Answer& answer) const;

  std::int64_t period_ns_;
  std::vector<Thread> threads_;
  std::vector<Sensed> cycles_;
  std::vector<Answer> answers_;
};

}  // namespace robotui::rt::supervisor
