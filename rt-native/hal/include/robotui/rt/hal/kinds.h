// The kinds of HAL that are built in.
#pragma once

#include <memory>

#include "robotui/rt/hal/hal.h"

namespace robotui::rt::hal {

// By `type` of the configuration, not yet open. Throws config::ConfigError where it is not built in, std::runtime_error
// where a library is none.
std::unique_ptr<Hal> create(const config::HalConfig& config);

}  // namespace robotui::rt::hal
