// What robotui-rt-ctl prints.
#pragma once

#include <string>

#include "robotui/rt/link/client.h"

namespace robotui::rt::supervisor {

std::string pluginTable(const link::Attachment& attachment);
std::string jointTable(const link::Attachment& attachment);
// One line about the loop of the HAL, and one for each thread of a host.
std::string loopTable(const link::Attachment& attachment);

}  // namespace robotui::rt::supervisor
