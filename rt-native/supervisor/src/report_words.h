// What plugins say by channels, read for clients that read none.
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/plugin/channel.h"

namespace robotui::rt::supervisor {

// The newest value of a channel; none where nobody writes it. `channels` are those of one host.
template <ChannelValue T>
std::optional<T> newestOf(const link::ChannelSegment& channels, std::string_view name) {
  const std::uint64_t id = channelFacts<T>(name).id();
  for (const link::ChannelSlot& slot : channels.slots) {
    if (slot.id.load(std::memory_order_acquire) != id) continue;
    // Its writer goes on meanwhile: one that was overwritten while it was read is followed by another one.
    for (int tries = 0; tries < 5; ++tries) {
      const std::uint64_t written = slot.written.load(std::memory_order_acquire);
      T value{};
      if (written != 0 && detail::fetch(slot, written - 1, &value, sizeof(value)) == detail::Fetch::kOk) return value;
    }
  }
  return std::nullopt;
}

inline std::string textOf(double number) {
  std::array<char, 32> room{};
  const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), number);
  return {room.data(), end};
}

}  // namespace robotui::rt::supervisor
