#include "gazebo_hal.h"

ROBOTUI_RT_HAL(robotui::rt::hal::gazebo::GazeboHal)
