#include "cartesian_tasks.h"

using robotui::rt::plugins::CartesianTasks;
ROBOTUI_RT_PLUGIN(CartesianTasks)
