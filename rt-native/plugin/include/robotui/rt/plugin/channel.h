// Named channels between the plugins of one robot, whatever process they run in: one writer, any number of readers, no
// locks.
//
// Each process has one segment of channels that it alone can write; all others map it read only, so a wild pointer
// breaks the channels of its own process at most. A channel keeps the last few values: a reader takes the newest or all
// in order. Both ends state the schema of the values (schema.h); a reader of another one is refused.
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
#include <utility>
#include <vector>

#include "robotui/rt/link/channels.h"
#include "robotui/rt/plugin/schema.h"

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

void store(ChannelSlot& slot, const void* value, std::size_t size) noexcept;
enum class Fetch { kNone, kOk, kOverwritten };
Fetch fetch(const ChannelSlot& slot, std::uint64_t number, void* value, std::size_t size) noexcept;

}  // namespace detail

// One channel as an end of it states it.
struct ChannelFacts {
  std::string_view name;
  Schema schema;
  std::size_t size;  // of one value, bytes

  constexpr std::uint64_t id() const noexcept {
    return detail::hash(name, detail::hash(schema.name) ^ (std::uint64_t{schema.version} << 32) ^ (size << 1));
  }
};

template <ChannelValue T>
constexpr ChannelFacts channelFacts(std::string_view name) noexcept {
  return {name, SchemaOf<T>::value, sizeof(T)};
}

// Whether a reader finds what it reads.
enum class ChannelState : std::uint8_t {
  kConnected,
  kNoWriter,
  kOtherSchema  // the channel of that name carries something else
};

// What a reader does where its channel has a writer of another schema when it is made.
enum class OtherSchema : std::uint8_t {
  kRefuse,  // it is not made: std::runtime_error with a sentence
  kAwait    // it reads nothing until a writer of its own schema comes
};

// Where the channels of one process are found. Used outside the control loop.
class ChannelDirectory {
 public:
  // `own` is writable and outlives all writers; `all` are the segments of every process, the own one among them.
  ChannelDirectory(ChannelSegment& own, std::vector<const ChannelSegment*> all);

  // Throws std::runtime_error with a sentence where the name is taken, a name is too long, or the values do not fit.
  ChannelSlot& open(const ChannelFacts& channel, std::uint32_t depth);
  static void close(ChannelSlot& slot) noexcept;

  // nullptr where nobody writes it now. A scan of atomics: not blocking.
  const ChannelSlot* find(std::uint64_t id) const noexcept;

  // Of any schema. A scan that compares names: not blocking, but slower.
  const ChannelSlot* find(std::string_view name) const noexcept;

  // Empty, or a sentence why a reader of this channel cannot read what its writer writes now.
  std::string objection(const ChannelFacts& reader) const;

 private:
  ChannelSegment* own_;
  std::vector<const ChannelSegment*> all_;
};

// The one that writes. write() may be called in the control loop.
template <ChannelValue T>
class ChannelWriter {
 public:
  ChannelWriter() = default;
  ChannelWriter(ChannelDirectory& directory, std::string_view name, std::uint32_t depth = 8)
      : slot_(&directory.open(channelFacts<T>(name), depth)) {}
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

// One of those who read. latest(), next() and state() may be called in the control loop; the writer may come and go
// meanwhile.
template <ChannelValue T>
class ChannelReader {
 public:
  ChannelReader() = default;

  // A writer of another schema that comes later is seen by state().
  ChannelReader(const ChannelDirectory& directory, std::string_view name, OtherSchema other = OtherSchema::kRefuse)
      : directory_(&directory), name_(name), id_(channelFacts<T>(name).id()) {
    const std::string why = other == OtherSchema::kRefuse ? objection() : std::string();
    if (!why.empty()) throw std::runtime_error(why);
  }

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

  // The next value not yet read, in order; false where there is none. What was overwritten meanwhile is counted as
  // lost.
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
  ChannelState state() noexcept {
    if (attach()) return ChannelState::kConnected;
    return directory_ == nullptr || directory_->find(std::string_view(name_)) == nullptr ? ChannelState::kNoWriter
                                                                                         : ChannelState::kOtherSchema;
  }

  // The sentence for kOtherSchema, else empty. Not real time.
  std::string objection() const {
    return directory_ == nullptr ? std::string() : directory_->objection(channelFacts<T>(name_));
  }

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
  std::string name_;
  std::uint64_t id_ = 0;
  std::uint64_t next_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace robotui::rt
