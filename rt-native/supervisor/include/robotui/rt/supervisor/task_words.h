// What a plugin says of its tasks (TaskReport), as words for clients that read no channels:
// docs/adr/0309-cartesian-plugins-say-their-tasks-by-a-channel.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/link/channels.h"
#include "robotui/rt/plugin/task_report.h"

namespace robotui::rt::supervisor {

// The newest report of a plugin; none where it says nothing of the kind. `channels` are those of its host.
std::optional<TaskReport> taskReport(const link::ChannelSegment& channels, std::string_view plugin);

// In lines: the indices of the joints that it moves, then each task, its fields divided by tabs: name, link, base,
// priority, `disabled`, `there`, `moving` or `stuck`, its mask as six digits, linear and angular speed.
std::string taskWords(const TaskReport& report);

}  // namespace robotui::rt::supervisor
