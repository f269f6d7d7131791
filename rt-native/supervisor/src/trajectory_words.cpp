#include "robotui/rt/supervisor/trajectory_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>

#include "robotui/rt/plugin/channel.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::array<std::string_view, 11> kPhases{"none",       "telling",  "checking", "refused",
                                                   "bad_joints", "moving",   "settling", "done",
                                                   "stopped",    "off_path", "off_goal"};

std::string_view wordOf(TrajectoryPhase phase) noexcept {
  const auto index = static_cast<std::size_t>(phase);
  return index < kPhases.size() ? kPhases[index] : kPhases[0];
}

std::string textOf(double number) {
  std::array<char, 32> room{};
  const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), number);
  return {room.data(), end};
}

// Another process wrote it: it stays one line.
std::string lineOf(const TrajectoryReport::Text& text) {
  std::string line(view(text));
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

std::string lineOf(std::span<const double> numbers) {
  std::string line;
  for (const double number : numbers) line += (line.empty() ? "" : " ") + textOf(number);
  return line;
}

}  // namespace

std::optional<TrajectoryReport> trajectoryReport(const link::ChannelSegment& channels, std::string_view plugin) {
  const std::string name = trajectoryChannel(plugin);
  const std::uint64_t id = channelFacts<TrajectoryReport>(name).id();
  for (const link::ChannelSlot& slot : channels.slots) {
    if (slot.id.load(std::memory_order_acquire) != id) continue;
    // Its writer goes on meanwhile: one that was overwritten while it was read is followed by another one.
    for (int tries = 0; tries < 5; ++tries) {
      const std::uint64_t written = slot.written.load(std::memory_order_acquire);
      TrajectoryReport report{};
      if (written != 0 && detail::fetch(slot, written - 1, &report, sizeof(report)) == detail::Fetch::kOk)
        return report;
    }
  }
  return std::nullopt;
}

std::string trajectoryWords(const TrajectoryReport& report, std::uint32_t joints) {
  const std::size_t count = std::min<std::size_t>(joints, report.positions.size());
  std::string words = std::to_string(report.told);
  words.append(" ").append(wordOf(report.told_phase)).append(" ").append(std::to_string(report.followed));
  words.append(" ").append(wordOf(report.phase)).append(" ").append(textOf(report.seconds));
  words.append("\n").append(lineOf(report.refusal)).append("\n").append(lineOf(report.ending));
  for (const auto* numbers : {&report.positions, &report.velocities, &report.accelerations})
    words.append("\n").append(lineOf(std::span(*numbers).first(count)));
  return words;
}

}  // namespace robotui::rt::supervisor
