// A YAML file as a Reader of its top.
#pragma once

#include "robotui/rt/config/reader.h"

namespace robotui::rt::config {

Reader readYamlFile(const std::filesystem::path& file, const Place& wanted, const std::string& what);

}  // namespace robotui::rt::config
