#include "gravity_compensation.h"

using robotui::rt::plugins::GravityCompensation;
ROBOTUI_RT_PLUGIN(GravityCompensation)
