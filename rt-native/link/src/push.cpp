#include "robotui/rt/link/push.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::link {

namespace {

bool isAllowed(const Push& push) {
  const bool are_numbers =
      std::all_of(push.force.begin(), push.force.end(), [](double each) { return std::isfinite(each); });
  const bool is_there = push.joint ? *push.joint < kMaxJoints : !push.link.empty();
  return push.number < kMostPushes && push.seconds >= 0 && push.seconds <= kLongestPush && are_numbers && is_there;
}

}  // namespace

std::string textOf(const Push& push) {
  std::ostringstream text;
  text.precision(17);
  text << "push " << push.number << ' ' << push.seconds;
  if (push.joint)
    text << " joint " << *push.joint << ' ' << push.force[0];
  else
    text << " link " << push.force[0] << ' ' << push.force[1] << ' ' << push.force[2] << ' ' << push.link;
  return text.str();
}

std::optional<Push> pushOf(std::string_view words) {
  std::istringstream text{std::string(words)};
  Push push;
  std::string kind;
  text >> push.number >> push.seconds >> kind;
  if (kind == "joint") {
    std::uint32_t joint = 0;
    text >> joint >> push.force[0];
    push.joint = joint;
  } else if (kind == "link") {
    text >> push.force[0] >> push.force[1] >> push.force[2] >> push.link;
  }
  if (text.fail() || !isAllowed(push)) return std::nullopt;
  return push;
}

}  // namespace robotui::rt::link
