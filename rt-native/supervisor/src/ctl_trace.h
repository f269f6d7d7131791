// Writes what the loops of a robot do, seen from outside.
#pragma once

#include <filesystem>

#include "robotui/rt/link/client.h"

namespace robotui::rt::supervisor {

// Looks on for so long, and writes the file: 0 where something was seen. Throws std::runtime_error with a sentence
// where it cannot be written.
int traceCycles(link::Client& client, const std::filesystem::path& file, double seconds);

}  // namespace robotui::rt::supervisor
