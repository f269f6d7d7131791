// Which threads answer, in cycles of the HAL.
#pragma once

#include <chrono>

#include "command_inbox.h"
#include "robotui/rt/config/plan.h"

namespace robotui::rt::hal {

CommandPlan commandPlan(const config::Plan& plan, std::chrono::nanoseconds period);

}  // namespace robotui::rt::hal
