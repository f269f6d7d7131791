#include "cycle_trace.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <limits>

namespace robotui::rt::supervisor {
namespace {

constexpr int kHal = 1;           // process and thread of the HAL; those of threads follow
constexpr std::size_t kBack = 8;  // cycles that an answer may be behind

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) continue;
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

// One event after the other, with microseconds.
class CycleTrace::Events {
 public:
  Events(std::ostream& out, std::int64_t zero_ns) : out_(out), zero_ns_(zero_ns) {
    out_ << "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[";
  }
  ~Events() { out_ << "\n]}\n"; }
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;

  void name(const char* what, int process, int thread, const std::string& name) {
    begin("M", what, process, thread) << ",\"args\":{\"name\":" << quoted(name) << "}}";
  }
  void span(const std::string& name, int process, int thread, std::int64_t from_ns, std::int64_t length_ns,
            std::uint64_t cycle) {
    begin("X", name, process, thread) << ",\"ts\":" << us(from_ns - zero_ns_)
                                      << ",\"dur\":" << us(std::max<std::int64_t>(length_ns, 0))
                                      << ",\"args\":{\"cycle\":" << cycle << "}}";
  }
  void counter(const std::string& name, std::int64_t at_ns, std::int64_t value_ns) {
    begin("C", name, kHal, kHal) << ",\"ts\":" << us(at_ns - zero_ns_) << ",\"args\":{\"us\":" << us(value_ns) << "}}";
  }

 private:
  std::ostream& begin(const char* kind, const std::string& name, int process, int thread) {
    out_ << (is_first_ ? "\n" : ",\n");
    is_first_ = false;
    return out_ << "{\"ph\":\"" << kind << "\",\"name\":" << quoted(name) << ",\"pid\":" << process
                << ",\"tid\":" << thread;
  }
  static std::string us(std::int64_t ns) {
    const std::string rest = std::to_string(std::abs(ns) % 1000);
    return (ns < 0 ? "-" : "") + std::to_string(std::abs(ns) / 1000) + "." + std::string(3 - rest.size(), '0') + rest;
  }

  std::ostream& out_;
  std::int64_t zero_ns_;
  bool is_first_ = true;
};

void CycleTrace::addAnswer(std::size_t thread, std::uint64_t cycle, std::int64_t written_ns,
                           std::vector<Phase> phases) {
  const auto begin = cycles_.rbegin();
  const auto end = begin + static_cast<std::ptrdiff_t>(std::min(kBack, cycles_.size()));
  const auto sensed = std::find_if(begin, end, [&](const Sensed& each) { return each.cycle == cycle; });
  if (thread >= threads_.size() || sensed == end || written_ns < sensed->at_ns) return;
  answers_.push_back({thread, cycle, sensed->at_ns, written_ns, std::move(phases)});
}

// How late each cycle was: against the grid on which the earliest one lies.
std::vector<std::int64_t> CycleTrace::lateness() const {
  std::vector<std::int64_t> late;
  std::int64_t earliest = std::numeric_limits<std::int64_t>::max();
  for (const Sensed& each : cycles_) {
    const std::int64_t since = each.at_ns - cycles_.front().at_ns;
    late.push_back(since - (since + period_ns_ / 2) / period_ns_ * period_ns_);
    earliest = std::min(earliest, late.back());
  }
  for (std::int64_t& each : late) each -= earliest;
  return late;
}

void CycleTrace::write(std::ostream& out) const {
  Events events(out, cycles_.empty() ? 0 : cycles_.front().at_ns);
  writeNames(events);
  writeCycles(events);
  for (const Answer& answer : answers_) writeAnswer(events, answer);
}

void CycleTrace::writeNames(Events& events) const {
  events.name("process_name", kHal, kHal, "HAL");
  events.name("thread_name", kHal, kHal, "cycle");
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    const int id = kHal + 1 + static_cast<int>(i);
    events.name("process_name", id, id, "host " + threads_[i].host);
    events.name("thread_name", id, id, threads_[i].name);
  }
}

// Of a cycle it is known when it sensed; what it waited for are the answers.
void CycleTrace::writeCycles(Events& events) const {
  const std::vector<std::int64_t> late = lateness();
  auto answer = answers_.begin();
  for (std::size_t i = 0; i < cycles_.size(); ++i) {
    std::int64_t last = cycles_[i].at_ns;
    for (; answer != answers_.end() && answer->cycle <= cycles_[i].cycle; ++answer) {
      if (answer->cycle == cycles_[i].cycle) last = std::max(last, answer->written_ns);
    }
    events.span("answers", kHal, kHal, cycles_[i].at_ns, last - cycles_[i].at_ns, cycles_[i].cycle);
    events.counter("late", cycles_[i].at_ns, late[i]);
  }
}

// The plugins run one after the other, up to the answer; what is before them is the wake-up.
void CycleTrace::writeAnswer(Events& events, const Answer& answer) const {
  const int id = kHal + 1 + static_cast<int>(answer.thread);
  std::int64_t at = answer.written_ns;
  for (auto phase = answer.phases.rbegin(); phase != answer.phases.rend(); ++phase) {
    const std::int64_t busy = std::clamp<std::int64_t>(phase->busy_ns, 0, at - answer.sensed_ns);
    at -= busy;
    events.span(phase->plugin, id, id, at, busy, answer.cycle);
  }
  events.span("wake-up", id, id, answer.sensed_ns, at - answer.sensed_ns, answer.cycle);
}

}  // namespace robotui::rt::supervisor
