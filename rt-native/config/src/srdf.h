// The groups of an SRDF: chains, sensors, postures.
#pragma once

#include "robotui/rt/config/config.h"
#include "urdf.h"

namespace robotui::rt::config {

// Fills chains, sensors and postures of a robot whose joints are known.
void readSrdf(const std::filesystem::path& file, const std::string& text, const Urdf& urdf, RobotDescription& robot,
              std::vector<std::string>& warnings);

}  // namespace robotui::rt::config
