// What the error codes of emergency messages mean (CiA 301 and CiA 402).
#pragma once

#include <cstdint>
#include <string>

namespace robotui::rt::hal::canopen {

// "0x3210 (DC link over-voltage)"; of a code that only the maker of the drive knows, its class.
std::string errorText(std::uint16_t code);

}  // namespace robotui::rt::hal::canopen
