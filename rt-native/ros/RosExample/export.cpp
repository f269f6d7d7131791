#include "ros_example.h"

using robotui::rt::plugins::RosExample;
ROBOTUI_RT_PLUGIN(RosExample)
