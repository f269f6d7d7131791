#include "ctl_table.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <memory>
#include <sstream>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/histogram.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/link/state.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::array<const char*, 7> kStates{"absent",  "loaded",   "stopped", "starting",
                                             "running", "stopping", "failed"};
constexpr std::array<const char*, 4> kControls{"free", "commanded", "holding", "safe"};

template <std::size_t kSize>
const char* word(const std::array<const char*, kSize>& words, std::uint32_t value) {
  return value < kSize ? words[value] : "?";
}

std::unique_ptr<link::BoardData> boardOf(const link::Attachment& attachment) {
  auto data = std::make_unique<link::BoardData>();
  link::BoardReader(*attachment.board).read(*data);
  return data;
}

double us(std::int64_t ns) { return static_cast<double>(ns) / 1000; }

void addHistogram(std::ostream& out, const char* title, const link::Histogram& shared) {
  const link::Histogram copy = link::relaxedCopy(shared);
  out << "  " << title << " p50 " << us(link::percentile(copy, 0.5)) << " p99 " << us(link::percentile(copy, 0.99))
      << " max " << us(copy.max_ns) << " us";
}

std::string ownerName(const link::BoardData& board, std::uint16_t owner) {
  return owner < board.plugins ? std::string(link::view(board.plugin[owner].name)) : "-";
}

// Nothing as long as all is well.
std::string counts(const link::JointState& joint) {
  const bool none = joint.clamped == 0 && joint.rejected == 0;
  return none ? "" : "  " + std::to_string(joint.clamped) + " cut, " + std::to_string(joint.rejected) + " refused";
}

}  // namespace

std::string pluginTable(const link::Attachment& attachment) {
  const auto board = boardOf(attachment);
  std::ostringstream out;
  for (std::uint32_t i = 0; i < board->plugins; ++i) {
    const auto& plugin = board->plugin[i];
    const std::uint32_t host = std::min(plugin.host, link::kMaxHosts - 1);
    out << std::left << std::setw(26) << link::view(plugin.name) << std::setw(10) << word(kStates, plugin.state)
        << std::setw(10) << link::view(board->host[host].name) << link::view(plugin.error) << '\n';
  }
  return out.str();
}

std::string jointTable(const link::Attachment& attachment) {
  const auto board = boardOf(attachment);
  auto frame = std::make_unique<link::FrameData>();
  link::StateReader(*attachment.state).newest(*frame);
  std::ostringstream out;
  out << std::fixed << std::setprecision(4);
  for (std::uint32_t i = 0; i < board->joints; ++i) {
    const auto& joint = frame->joints[i];
    out << std::left << std::setw(26) << link::view(board->joint[i].name) << std::right << std::setw(10)
        << joint.link_position << std::setw(10) << joint.position_reference << "  " << std::left << std::setw(10)
        << word(kControls, joint.control) << ownerName(*board, joint.owner) << counts(joint) << '\n';
  }
  return out.str();
}

std::string loopTable(const link::Attachment& attachment) {
  const auto board = boardOf(attachment);
  std::ostringstream out;
  const auto& loop = attachment.state->loop;
  out << std::fixed << std::setprecision(1) << "hal " << link::relaxedLoad(loop.cycles) << " cycles, "
      << link::relaxedLoad(loop.overruns) << " overruns, " << link::relaxedLoad(loop.missed_commands) << " missed, "
      << link::relaxedLoad(loop.allocations) << " allocations";
  addHistogram(out, "wake-up", loop.wake_up);
  addHistogram(out, "busy", loop.busy);
  out << '\n';
  for (std::uint32_t host = 0; host < attachment.hosts.size() && host < board->hosts; ++host) {
    const auto& segment = *attachment.hosts[host];
    const std::uint32_t threads = std::min(link::relaxedLoad(segment.threads), link::kMaxThreads);
    for (std::uint32_t i = 0; i < threads; ++i) {
      const auto& thread = segment.thread_statistics[i];
      out << link::view(board->host[host].name) << '/' << link::view(thread.name) << ' '
          << link::relaxedLoad(thread.cycles) << " cycles, " << link::relaxedLoad(thread.overruns) << " overruns, "
          << link::relaxedLoad(thread.allocations) << " allocations";
      addHistogram(out, "wake-up", thread.wake_up);
      addHistogram(out, "busy", thread.busy);
      out << '\n';
    }
  }
  return out.str();
}

}  // namespace robotui::rt::supervisor
