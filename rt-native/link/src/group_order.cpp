#include "robotui/rt/link/group_order.h"

#include <sstream>

namespace robotui::rt::link {

namespace {

constexpr unsigned kRefusals = 4;

}  // namespace

std::string textOf(const GroupOrder& order) {
  std::ostringstream text;
  text << "group " << order.group << ' ' << order.cycle << ' ' << order.every << ' ' << order.until << ' '
       << order.start << ' ' << order.stop;
  for (std::uint32_t joint = 0; joint < kMaxJoints; ++joint) {
    if (order.joints.test(joint)) text << ' ' << joint << '=' << order.owners.at(joint);
  }
  return text.str();
}

std::string textOf(const GroupOutcome& outcome) {
  std::ostringstream text;
  text << "switched " << outcome.group << ' ' << static_cast<unsigned>(outcome.refusal) << ' ' << outcome.cycle << ' '
       << outcome.lacking;
  return text.str();
}

std::optional<GroupOrder> groupOrderOf(std::string_view words) {
  std::istringstream text{std::string(words)};
  GroupOrder order;
  text >> order.group >> order.cycle >> order.every >> order.until >> order.start >> order.stop;
  if (text.fail() || order.group == 0 || order.every == 0) return std::nullopt;
  std::uint32_t joint = 0;
  std::uint16_t owner = 0;
  for (char sign = 0; text >> joint >> sign >> owner;) {
    if (sign != '=' || joint >= kMaxJoints) return std::nullopt;
    order.joints.set(joint);
    order.owners.at(joint) = owner;
  }
  if (!text.eof()) return std::nullopt;
  return order;
}

std::optional<GroupOutcome> groupOutcomeOf(std::string_view words) {
  std::istringstream text{std::string(words)};
  GroupOutcome outcome;
  unsigned refusal = 0;
  text >> outcome.group >> refusal >> outcome.cycle >> outcome.lacking;
  if (text.fail() || refusal >= kRefusals) return std::nullopt;
  outcome.refusal = static_cast<GroupRefusal>(refusal);
  return outcome;
}

}  // namespace robotui::rt::link
