// Named channels between the plugins of one robot, whatever process they run in: one writer, any number of readers, no locks.
//
// Each process has one segment of channels that it alone can write; all others map it read only, so a wild pointer breaks the
// channels of its own process at most. A channel keeps the last few values: a reader takes the newest or all in order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "robotui/rt/link/channels.h"

namespace robotui::rt {

using link::ChannelSegment;
using link::ChannelSlot;
using link::kChannelWords;
using link::kMaxChannels;

namespace detail {

constexpr std::uint64_t hash(std::string_view text, std::uint64_t seed = 14695981039346656037ULL) {
  for (const char c : text) {
    seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return seed | 1;  // never 0
}

template <typename T>
constexpr std::uint64_t typeHash() {
  return hash(__PRETTY_FUNCTION__) ^ (sizeof(T) << 1);
}

void store(ChannelSlot& slot, const void* value, std::size_t size) noexcept;
enum class Fetch { kNone, kOk, kOverwritten };
Fetch fetch(const ChannelSlot& slot, std::uint64_t number, void* value, std::size_t size) noexcept;

}  // namespace detail

// Where the channels of one process are found. Used outside the control loop.
class ChannelDirectory {
 public:
  // `own` is writable and outlives all writers; `all` are the segments of every process, the own one among them.
  ChannelDirectory(ChannelSegment& own, std::vector<const ChannelSegment*> all);

  // Throws std::runtime_error with a sentence where the name is taken, too long, or the values do not fit.
  ChannelSlot& open(std::string_view name, std::uint64_t type, std::size_t size, std::uint32_t depth);
  static void close(ChannelSlot& slot) noexcept;

  // nullptr where nobody writes it now. A scan of atomics: not blocking.
  const ChannelSlot* find(std::uint64_t id) const noexcept;

 private:
  ChannelSegment* own_;
  std::vector<const ChannelSegment*> all_;
};

// The one that writes. write() may be called in the control loop.
template <typename T>
class ChannelWriter {
  static_assert(std::is_trivially_copyable_v<T>, "a channel carries bytes between processes");

 public:
  ChannelWriter() = default;
  ChannelWriter(ChannelDirectory& directory, std::string_view name, std::uint32_t depth = 8)
      : slot_(&directory.open(name, detail::typeHash<T>(), sizeof(T), depth)) {}
  ChannelWriter(ChannelWriter&& other) noexcept : slot_(std::exchange(other.slot_, nullptr)) {}
  ChannelWriter& operator=(ChannelWriter&& other) noexcept {
    std::swap(slot_, other.slot_);
    return *this;
  }
  ~ChannelWriter() {
    if (slot_ != nullptr) {
      ChannelDirectory::close(*slot_);
    }
  }

  void write(const T& value) noexcept {
    if (slot_ != nullptr) {
      detail::store(*slot_, &value, sizeof(T));
    }
  }

 private:
  ChannelSlot* slot_ = nullptr;
};

// One of those who read. latest() and next() may be called in the control loop; the writer may come and go meanwhile.
template <typename T>
class ChannelReader {
  static_assert(std::is_trivially_copyable_v<T>, "a channel carries bytes between processes");

 public:
  ChannelReader() = default;
  ChannelReader(const ChannelDirectory& directory, std::string_view name)
      : directory_(&directory), id_(detail::hash(name, detail::typeHash<T>())) {}

  // The newest value; false where there is none.
  bool latest(T& value) noexcept {
    if (!attach()) {
      return false;
    }
    const std::uint64_t written = slot_->written.load(std::memory_order_acquire);
    if (written == 0 || detail::fetch(*slot_, written - 1, &value, sizeof(T)) != detail::Fetch::kOk) {
      return false;
    }
    next_ = written;
    return true;
  }

  // The next value not yet read, in order; false where there is none. What was overwritten meanwhile is counted as lost.
  bool next(T& value) noexcept {
    if (!attach()) {
      return false;
    }
    const std::uint64_t written = slot_->written.load(std::memory_order_acquire);
    skipLost(written);
    // Bounded, whatever the writer's process made of its numbers.
    for (std::uint32_t tries = 0; next_ < written && tries < kChannelWords; ++tries) {
      const auto got = detail::fetch(*slot_, next_++, &value, sizeof(T));
      if (got == detail::Fetch::kOk) {
        return true;
      }
      ++lost_;
    }
    return false;
  }

  bool isConnected() noexcept { return attach(); }
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  bool attach() noexcept {
    if (slot_ != nullptr && slot_->id.load(std::memory_order_acquire) == id_) {
      return true;
    }
    slot_ = directory_ == nullptr ? nullptr : directory_->find(id_);
    next_ = 0;
    return slot_ != nullptr;
  }

  void skipLost(std::uint64_t written) noexcept {
    const std::uint64_t depth = std::min(slot_->depth.load(std::memory_order_relaxed), kChannelWords);
    if (next_ > written) {
      next_ = 0;  // another writer began anew
    }
    if (written > depth && next_ < written - depth) {
      lost_ += written - depth - next_;
      next_ = written - depth;
    }
  }

  const ChannelDirectory* directory_ = nullptr;
  const ChannelSlot* slot_ = nullptr;
  std::uint64_t id_ = 0;
  std::uint64_t next_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace robotui::rt
