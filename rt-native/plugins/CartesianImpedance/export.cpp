#include "cartesian_impedance.h"

using robotui::rt::plugins::CartesianImpedance;
ROBOTUI_RT_PLUGIN(CartesianImpedance)
