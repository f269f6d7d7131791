#include "robotui/rt/supervisor/trajectory_words.h"

#include <algorithm>
#include <array>
#include <span>

#include "report_words.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::array<std::string_view, 11> kPhases{"none",       "telling",  "checking", "refused",
                                                   "bad_joints", "moving",   "settling", "done",
                                                   "stopped",    "off_path", "off_goal"};

std::string_view wordOf(TrajectoryPhase phase) noexcept {
  const auto index = static_cast<std::size_t>(phase);
  return index < kPhases.size() ? kPhases[index] : kPhases[0];
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
  return newestOf<TrajectoryReport>(channels, trajectoryChannel(plugin));
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
