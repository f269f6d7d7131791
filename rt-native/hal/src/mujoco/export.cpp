#include "mujoco_hal.h"

ROBOTUI_RT_HAL(robotui::rt::hal::MujocoHal)
