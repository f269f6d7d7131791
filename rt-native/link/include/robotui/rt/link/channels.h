// Named channels between plugins: one segment a process, which it alone can write. What plugins use is
// plugin/channel.h.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/link/segment.h"

namespace robotui::rt::link {

inline constexpr std::uint32_t kMaxChannels = 32;     // of one process
inline constexpr std::uint32_t kChannelWords = 1024;  // 8 KiB: a value and its sequence, times the depth, fit into it

// A place for one channel. `id` is written last and cleared first: 0 is free.
struct ChannelSlot {
  std::atomic<std::uint64_t> id;       // of name, schema and size
  std::atomic<std::uint64_t> written;  // values so far
  std::atomic<std::uint32_t> words;    // of one value and its sequence
  std::atomic<std::uint32_t> depth;    // values that are kept
  std::atomic<std::uint32_t> size;     // of one value, bytes
  std::atomic<std::uint32_t> version;  // of its schema
  Name name;
  Name schema;
  std::array<std::atomic<std::uint64_t>, kChannelWords> data;
};

struct ChannelSegment {
  Header header;
  std::array<ChannelSlot, kMaxChannels> slots;
};

template <>
struct SegmentTraits<ChannelSegment> {
  static constexpr SegmentKind kind = SegmentKind::kChannels;
};

}  // namespace robotui::rt::link
