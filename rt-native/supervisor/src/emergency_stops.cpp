#include "robotui/rt/supervisor/emergency_stops.h"

#include <algorithm>
#include <bitset>
#include <sstream>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {
namespace {

constexpr const char* kUnread = " cannot be read, which counts as pressed";

bool isOne(std::uint16_t bits) { return std::bitset<link::kMaxStops>(bits).count() == 1; }

}  // namespace

std::string EmergencyStops::named(std::uint16_t bits) const {
  std::string names;
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    if ((bits >> i & 1U) != 0) names += (names.empty() ? "'" : ", '") + stops_[i].name + "'";
  }
  return (isOne(bits) ? "emergency stop " : "emergency stops ") + names;
}

std::string EmergencyStops::causeOf(const link::StopBits& bits) const {
  std::string text;
  if (bits.pressed != 0) text = "The " + named(bits.pressed) + (isOne(bits.pressed) ? " is" : " are") + " pressed";
  if (bits.unread != 0) text += (text.empty() ? "The " : ", and the ") + named(bits.unread) + kUnread;
  return text;
}

void EmergencyStops::handle(std::string_view words) {
  std::istringstream text{std::string(words)};
  link::StopBits now;
  std::uint64_t cycle = 0;
  text >> now.pressed >> now.unread >> cycle;
  if (text.fail() || now == bits_) return;
  bits_ = now;
  if (now.any())
    log_.error(causeOf(now) + ", in cycle " + std::to_string(cycle) + ": all joints are in their safe state.");
  else
    log_.info(
        "No emergency stop is pressed any more. Nothing moves by itself: start the plugins again, such as "
        "robotui-rt-ctl switch PLUGIN 1.");
}

std::string EmergencyStops::objection() const {
  return bits_.any() ? causeOf(bits_) + ": nothing that leads joints can be started until it is released." : "";
}

std::string EmergencyStops::objectionToPress(std::string_view name) const {
  if (stops_.empty()) return "This robot has no emergency stops: name them in emergency_stops of HALInterface.";
  if (hal_.type != "dummy" && hal_.type != "mujoco" && hal_.type != "gazebo" && hal_.type != "library")
    return "The emergency stops of a HAL of the type " + hal_.type + " are real: press and release them by hand.";
  const bool is_there =
      name.empty() || std::any_of(stops_.begin(), stops_.end(), [&](const auto& stop) { return stop.name == name; });
  return is_there ? ""
                  : "There is no emergency stop '" + std::string(name.substr(0, link::kNameLength)) +
                        "'. There are: " + link::listed(stops_, &config::EmergencyStop::name, "none") + ".";
}

std::string EmergencyStops::lines() const {
  std::string text;
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    const bool pressed = (bits_.pressed >> i & 1U) != 0;
    const bool unread = (bits_.unread >> i & 1U) != 0;
    text += std::string(text.empty() ? "" : "\n") +
            (pressed  ? "pressed"
             : unread ? "unread"
                      : "released") +
            "\t" + stops_[i].name;
  }
  return text;
}

}  // namespace robotui::rt::supervisor
