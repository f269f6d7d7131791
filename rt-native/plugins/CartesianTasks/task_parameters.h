// The parameters of CartesianTasks, as they are written: docs/rt-cartesian.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cartesian_task.h"
#include "part_distances.h"
#include "robotui/rt/config/reader.h"

namespace robotui::rt::plugins {

struct TaskParameters {
  std::vector<TaskDescription> tasks;  // by priority
  std::vector<Joint*> joints;
  std::string posture;         // of the SRDF; empty is where the joints are at the start
  double posture_speed = 0.2;  // fraction of the velocity limits
  std::optional<DistanceParameters> distance;
};

// Throws ConfigError. Not real time.
TaskParameters readTaskParameters(const config::Reader& params, RobotInterface& robot);

}  // namespace robotui::rt::plugins
