// What a plugin of type JointTrajectory says of trajectories (TrajectoryReport), as words for clients that read no
// channels: docs/adr/0273-trajectories-are-followed-for-clients-of-any-framework.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/link/channels.h"
#include "robotui/rt/plugin/trajectory_report.h"

namespace robotui::rt::supervisor {

// The newest report of a plugin; none where it says nothing of the kind. `channels` are those of its host.
std::optional<TrajectoryReport> trajectoryReport(const link::ChannelSegment& channels, std::string_view plugin);

// In lines: `TOLD PHASE FOLLOWED PHASE SECONDS`, why what was told was refused, why what was followed was given up,
// then the positions, velocities and accelerations of the first `joints` joints of the robot.
std::string trajectoryWords(const TrajectoryReport& report, std::uint32_t joints);

}  // namespace robotui::rt::supervisor
