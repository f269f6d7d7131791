#include "joint_impedance.h"

using robotui::rt::plugins::JointImpedance;
ROBOTUI_RT_PLUGIN(JointImpedance)
