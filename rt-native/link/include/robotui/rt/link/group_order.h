// A group of plugins that is switched in one cycle or not at all: what the supervisor orders, and what the HAL answers.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::link {

struct GroupOrder {
  std::uint32_t group = 0;  // from 1
  std::uint64_t cycle = 0;  // of the HAL, in which it is to be switched
  std::uint64_t every = 1;  // or that many cycles later, and so on, until all are ready
  std::uint64_t until = 0;  // the last cycle: then nothing is switched
  std::bitset<kMaxPlugins> start{};
  std::bitset<kMaxPlugins> stop{};
  std::bitset<kMaxJoints> joints{};                // that change hands
  std::array<std::uint16_t, kMaxJoints> owners{};  // of these joints afterwards, or kNobody
};

// Why nothing was switched.
enum class GroupRefusal : std::uint8_t {
  kNone = 0,      // it was switched
  kNotReady = 1,  // not all plugins were ready in time
  kSafe = 2,      // an emergency stop is pressed, the hardware is away, or the control ends
  kCancelled = 3,
};

struct GroupOutcome {
  std::uint32_t group = 0;
  GroupRefusal refusal = GroupRefusal::kNone;
  std::uint64_t cycle = 0;
  std::bitset<kMaxPlugins> lacking{};  // that were not ready
};

// Packets of the socket: "group GROUP CYCLE EVERY UNTIL START STOP JOINT=OWNER...", START and STOP as bits, and
// "switched GROUP REFUSAL CYCLE LACKING".
std::string textOf(const GroupOrder& order);
std::string textOf(const GroupOutcome& outcome);

// Nothing where the words behind the verb are not that.
std::optional<GroupOrder> groupOrderOf(std::string_view words);
std::optional<GroupOutcome> groupOutcomeOf(std::string_view words);

}  // namespace robotui::rt::link
