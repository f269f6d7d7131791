#include "robotui/rt/link/joint_event.h"

#include <cmath>
#include <sstream>

namespace robotui::rt::link {

namespace {

constexpr unsigned kCauses = 6;
constexpr unsigned kObjections = 5;

}  // namespace

std::string textOf(const JointEvent& event) {
  std::ostringstream text;
  text << "joints " << static_cast<unsigned>(event.cause) << ' ' << static_cast<unsigned>(event.objection) << ' '
       << event.plugin << ' ' << event.joint << ' ' << event.grant << ' ' << event.rejected << ' ' << event.cycle << ' '
       << event.error << ' ' << event.stops.pressed << ' ' << event.stops.unread << ' ' << event.joints;
  return text.str();
}

std::optional<JointEvent> jointEventOf(std::string_view words) {
  std::istringstream text{std::string(words)};
  unsigned cause = 0;
  unsigned objection = 0;
  JointEvent event;
  text >> cause >> objection >> event.plugin >> event.joint >> event.grant >> event.rejected >> event.cycle >>
      event.error >> event.stops.pressed >> event.stops.unread >> event.joints;
  if (text.fail() || cause >= kCauses || objection >= kObjections || event.joint >= kMaxJoints ||
      event.plugin >= kMaxPlugins || !std::isfinite(event.error))
    return std::nullopt;
  event.cause = static_cast<FallCause>(cause);
  event.objection = static_cast<Objection>(objection);
  return event;
}

}  // namespace robotui::rt::link
