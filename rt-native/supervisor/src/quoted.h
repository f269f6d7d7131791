// What a client wrote, as it can be repeated to it.
#pragma once

#include <string>
#include <string_view>

namespace robotui::rt::supervisor {

inline std::string quoted(std::string_view words) { return "'" + std::string(words.substr(0, 80)) + "'"; }

}  // namespace robotui::rt::supervisor
