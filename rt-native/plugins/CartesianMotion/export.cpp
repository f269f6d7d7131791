#include "cartesian_motion.h"

using robotui::rt::plugins::CartesianMotion;
ROBOTUI_RT_PLUGIN(CartesianMotion)
