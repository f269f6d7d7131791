// Makes one drive ready for cycles: what it is, what it watches, how it speaks, and into the state "operational".
#pragma once

#include "bus.h"
#include "pdo_layout.h"
#include "settings.h"

namespace robotui::rt::hal::canopen {

struct StartUp {
  PdoLayout layout;
  std::vector<std::string> warnings;
};

// On ordinary threads: it waits, for each object as long as the settings say. The drive is not enabled by it. Throws
// std::runtime_error with a sentence for the user.
StartUp startUp(const Bus& bus, const Settings& settings, const DriveSettings& drive);

// "The drive of 'elbow' (node 3)"
std::string nameOf(const DriveSettings& drive);

}  // namespace robotui::rt::hal::canopen
