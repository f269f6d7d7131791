#include "joint_trajectory.h"

using robotui::rt::plugins::JointTrajectory;
ROBOTUI_RT_PLUGIN(JointTrajectory)
