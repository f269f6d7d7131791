// robotui-rt-ctl push: a simulated robot is pushed, as a hand would do it.
#pragma once

#include <string>
#include <vector>

#include "robotui/rt/link/client.h"

namespace robotui::rt::supervisor {

// JOINT EFFORT, or LINK X Y Z. Pushes for so long, since the push ends with this process, and says how far joints
// moved: 0, or 1 after it said why not.
int pushRobot(link::Client& client, const std::vector<std::string>& words, double seconds);

}  // namespace robotui::rt::supervisor
