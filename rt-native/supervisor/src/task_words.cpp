#include "robotui/rt/supervisor/task_words.h"

#include <algorithm>

#include "report_words.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::array<std::string_view, 4> kPhases{"disabled", "there", "moving", "stuck"};
constexpr std::uint32_t kAxes = 6;

std::string_view wordOf(TaskPhase phase) noexcept {
  const auto index = static_cast<std::size_t>(phase);
  return index < kPhases.size() ? kPhases[index] : kPhases[0];
}

// Another process wrote it: it stays one field.
std::string fieldOf(const TaskReport::Text& text) {
  std::string field(view(text));
  std::replace_if(
      field.begin(), field.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return field;
}

std::string lineOf(const TaskReport::Task& task) {
  std::string mask;
  for (std::uint32_t axis = 0; axis < kAxes; ++axis) mask += (task.mask >> axis & 1U) != 0 ? '1' : '0';
  return fieldOf(task.name) + "\t" + fieldOf(task.link) + "\t" + fieldOf(task.base) + "\t" +
         std::to_string(task.priority) + "\t" + std::string(wordOf(task.phase)) + "\t" + mask + "\t" +
         textOf(task.linear) + "\t" + textOf(task.angular);
}

}  // namespace

std::optional<TaskReport> taskReport(const link::ChannelSegment& channels, std::string_view plugin) {
  return newestOf<TaskReport>(channels, taskChannel(plugin));
}

std::string taskWords(const TaskReport& report) {
  std::string words;
  for (std::uint32_t joint = 0; joint < link::kMaxJoints; ++joint) {
    if (hasJoint(report, joint)) words += (words.empty() ? "" : " ") + std::to_string(joint);
  }
  const std::size_t count = std::min<std::size_t>(report.count, report.tasks.size());
  for (std::size_t i = 0; i < count; ++i) words.append("\n").append(lineOf(report.tasks[i]));
  return words;
}

}  // namespace robotui::rt::supervisor
