#include "ctl_table.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iomanip>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/histogram.h"
#include "robotui/rt/link/host_damage.h"
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

// On a busy machine the writer may have to wait in the middle of its writing.
template <typename Try>
void read(const Try& attempt, const char* what) {
  for (int i = 0; i < 100; ++i) {
    if (attempt() == link::Read::kNew) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  throw std::runtime_error(std::string("The ") + what +
                           " of the robot cannot be read: its writer stopped in the middle.");
}

std::unique_ptr<link::BoardData> boardOf(const link::Attachment& attachment) {
  auto data = std::make_unique<link::BoardData>();
  read([&] { return link::BoardReader(*attachment.board).read(*data); }, "board");
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

// What a broken plugin has left in the memory of its host is named, and not shown.
std::string damages(const link::Attachment& attachment, const link::BoardData& board) {
  std::string text;
  for (std::uint32_t host = 0; host < attachment.hosts.size() && host < board.hosts; ++host) {
    const std::string damage = link::damageOf(*attachment.hosts[host]);
    if (!damage.empty()) {
      text += "The memory of the host " + std::string(link::view(board.host[host].name)) + " is damaged (" + damage +
              "): what stands there is left out.\n";
    }
  }
  return text;
}

// Why joints are safe: what is known of the plugins that own them.
std::string reasons(const link::BoardData& board, const link::FrameData& frame) {
  std::string text;
  for (std::uint32_t i = 0; i < board.plugins; ++i) {
    const auto end = frame.joints.begin() + board.joints;
    const bool is_safe = std::any_of(frame.joints.begin(), end, [&](const link::JointState& joint) {
      return joint.owner == i && joint.control == static_cast<std::uint8_t>(link::Control::kSafe);
    });
    const std::string_view error = link::view(board.plugin[i].error);
    if (is_safe && !error.empty()) {
      text += std::string(link::view(board.plugin[i].name)) + " is " + word(kStates, board.plugin[i].state) + ": " +
              std::string(error) + "\n";
    }
  }
  return text;
}

// Said of the robot as a whole, also where no plugin leads a joint.
std::string emergency(const link::FrameData& frame) {
  constexpr std::uint32_t kEmergencyStop = 3;  // of hal::Status
  return frame.hal_status == kEmergencyStop
             ? "An emergency stop is pressed, and all joints are safe: robotui-rt-ctl estop says which.\n"
             : "";
}

// What runs in a thread: its state is that of the board, as everywhere.
std::string pluginsIn(const link::BoardData& board, std::uint32_t host, std::uint32_t thread) {
  std::string text;
  for (std::uint32_t i = 0; i < board.plugins; ++i) {
    const auto& plugin = board.plugin[i];
    if (plugin.host == host && plugin.thread == thread) {
      text += (text.empty() ? "  " : ", ") + std::string(link::view(plugin.name)) + " " + word(kStates, plugin.state) +
              (link::view(plugin.error).empty() ? "" : " (list says why)");
    }
  }
  return text;
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
  auto frame = std::make_unique<link::FrameData>();
  if (link::StateReader(*attachment.state).newest(*frame) == link::Read::kNew) out << emergency(*frame);
  out << damages(attachment, *board);
  return out.str();
}

std::string jointTable(const link::Attachment& attachment) {
  const auto board = boardOf(attachment);
  auto frame = std::make_unique<link::FrameData>();
  read([&] { return link::StateReader(*attachment.state).newest(*frame); }, "state");
  std::ostringstream out;
  out << std::fixed << std::setprecision(4);
  for (std::uint32_t i = 0; i < board->joints; ++i) {
    const auto& joint = frame->joints[i];
    out << std::left << std::setw(26) << link::view(board->joint[i].name) << std::right << std::setw(10)
        << joint.link_position << std::setw(10) << joint.position_reference << "  " << std::left << std::setw(10)
        << word(kControls, joint.control) << ownerName(*board, joint.owner) << counts(joint) << '\n';
  }
  out << emergency(*frame) << reasons(*board, *frame) << damages(attachment, *board);
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
    if (!link::damageOf(segment).empty()) continue;
    const std::uint32_t threads = std::min(link::relaxedLoad(segment.threads), link::kMaxThreads);
    for (std::uint32_t i = 0; i < threads; ++i) {
      const auto& thread = segment.thread_statistics[i];
      out << link::view(board->host[host].name) << '/' << link::view(thread.name) << ' '
          << link::relaxedLoad(thread.cycles) << " cycles, " << link::relaxedLoad(thread.overruns) << " overruns, "
          << link::relaxedLoad(thread.allocations) << " allocations";
      addHistogram(out, "wake-up", thread.wake_up);
      addHistogram(out, "busy", thread.busy);
      out << pluginsIn(*board, host, i) << '\n';
    }
  }
  out << damages(attachment, *board);
  return out.str();
}

}  // namespace robotui::rt::supervisor
