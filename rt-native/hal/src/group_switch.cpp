#include "group_switch.h"

namespace robotui::rt::hal {

using link::GroupRefusal;
using link::PluginState;

bool GroupSwitch::cancel(std::uint32_t group) noexcept {
  Request request{{}, true};
  request.order.group = group;
  return orders_.push(request);
}

void GroupSwitch::takeRequests(std::uint64_t cycle, const CommandInbox& inbox) noexcept {
  for (Request request; orders_.pop(request);) {
    const bool is_pending = pending_.group != 0;
    if (!request.is_cancelled && !is_pending)
      begin(request.order, inbox);
    else if (request.is_cancelled && is_pending && pending_.group == request.order.group)
      end(GroupRefusal::kCancelled, cycle, {});
  }
}

void GroupSwitch::begin(const link::GroupOrder& order, const CommandInbox& inbox) noexcept {
  pending_ = order;
  for (std::uint16_t plugin = 0; plugin < link::kMaxPlugins; ++plugin)
    progress_.at(plugin) = {inbox.progressOf(plugin), 0, false};
}

// What a process that is gone wrote last says nothing: its thread must go on, and be ready.
bool GroupSwitch::isReady(std::uint16_t plugin, std::uint64_t cycle, const CommandInbox& inbox) noexcept {
  Progress& progress = progress_.at(plugin);
  const std::uint64_t now = inbox.progressOf(plugin);
  if (now != progress.cycles) progress = {now, cycle, true};
  if (!progress.is_known || cycle - progress.changed_at > 2 * inbox.everyOf(plugin) + 1) return false;
  const PluginState state = inbox.stateOf(plugin);
  if (pending_.start.test(plugin)) return state == PluginState::kStarting;
  return state == PluginState::kStopping || state == PluginState::kStopped || state == PluginState::kFailed;
}

std::bitset<link::kMaxPlugins> GroupSwitch::lacking(std::uint64_t cycle, const CommandInbox& inbox) noexcept {
  std::bitset<link::kMaxPlugins> lacking;
  for (std::uint16_t plugin = 0; plugin < link::kMaxPlugins; ++plugin) {
    const bool is_member = pending_.start.test(plugin) || pending_.stop.test(plugin);
    if (is_member && !isReady(plugin, cycle, inbox)) lacking.set(plugin);
  }
  return lacking;
}

void GroupSwitch::look(std::uint64_t cycle, const CommandInbox& inbox, bool all_safe) noexcept {
  takeRequests(cycle, inbox);
  if (pending_.group == 0) return;
  const auto unready = lacking(cycle, inbox);
  if (all_safe && pending_.start.any()) {
    end(GroupRefusal::kSafe, cycle, {});
  } else if (unready.none() && cycle >= pending_.cycle && (cycle - pending_.cycle) % pending_.every == 0) {
    handOver();
    end(GroupRefusal::kNone, cycle, {});
  } else if (cycle >= pending_.until) {
    end(GroupRefusal::kNotReady, cycle, unready);
  }
}

void GroupSwitch::handOver() noexcept {
  for (std::uint32_t joint = 0; joint < link::kMaxJoints; ++joint) {
    if (pending_.joints.test(joint)) handed_.at(joint) = {link::kNobody, pending_.owners.at(joint), 0, true, true};
  }
  switched_ = pending_.group;
}

void GroupSwitch::end(GroupRefusal refusal, std::uint64_t cycle,
                      const std::bitset<link::kMaxPlugins>& lacking) noexcept {
  outcomes_.push({pending_.group, refusal, cycle, lacking});
  pending_.group = 0;
}

// The supervisor grants a joint once for the group, or releases it: as soon as one of that is seen the board is right.
std::pair<std::uint16_t, std::uint32_t> GroupSwitch::holder(std::uint32_t joint, std::uint16_t owner,
                                                            std::uint32_t grant) noexcept {
  Handed& handed = handed_.at(joint);
  if (!handed.counts) return {owner, grant};
  if (handed.is_new) handed = {owner, handed.owner, grant, false, true};
  const bool is_released = handed.owner == link::kNobody;
  handed.counts = grant == handed.grant && (!is_released || owner == handed.before);
  if (!handed.counts) return {owner, grant};
  return {handed.owner, is_released ? grant : grant + 1};
}

}  // namespace robotui::rt::hal
