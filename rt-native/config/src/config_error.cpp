#include "robotui/rt/config/config.h"

namespace robotui::rt::config {
namespace {

std::string describePlace(const Place& place) {
  std::string text = place.file.string();
  if (place.line > 0) {
    text += (text.empty() ? "line " : ":") + std::to_string(place.line);
    if (place.column > 0) text += ":" + std::to_string(place.column);
  }
  return text.empty() ? text : text + ": ";
}

}  // namespace

ConfigError::ConfigError(const Place& place, const std::string& what)
    : std::runtime_error(describePlace(place) + what) {}

}  // namespace robotui::rt::config
