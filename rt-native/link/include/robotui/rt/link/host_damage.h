// Whether the memory of a host is what a host writes: a plugin can write wildly into it, and only there.
#pragma once

#include <string>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::link {

// Empty, or what cannot be so, as words such as "its head is overwritten". Not all damage can be seen: a counter may
// have any value. Bounded, and never misled by a host that writes meanwhile.
std::string damageOf(const HostSegment& host);

}  // namespace robotui::rt::link
