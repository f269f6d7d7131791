#include "robotui/rt/plugin/channel.h"

#include <algorithm>

#include "robotui/rt/link/board.h"

// Thread sanitizer does not model fences. It need not here: all accesses around them are atomic.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wtsan"
#endif

namespace robotui::rt {
namespace {

constexpr std::size_t wordsOf(std::size_t size) { return (size + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t); }

// The first word of value n is 2n + 2 when it is whole and odd while it is written.
constexpr std::uint64_t wholeMark(std::uint64_t number) { return 2 * number + 2; }

// What another process wrote is not believed: a place must lie within the data.
bool placeOf(const ChannelSlot& slot, std::uint64_t number, std::size_t size, std::size_t& place) noexcept {
  const std::uint64_t words = slot.words.load(std::memory_order_relaxed);
  const std::uint64_t depth = slot.depth.load(std::memory_order_relaxed);
  if (words != wordsOf(size) + 1 || depth == 0 || words * depth > kChannelWords) {
    return false;
  }
  place = static_cast<std::size_t>((number % depth) * words);
  return true;
}

bool isNamed(const ChannelSlot& slot, std::string_view name) noexcept {
  return slot.id.load(std::memory_order_acquire) != 0 && link::view(slot.name) == name;
}

void mustFit(std::string_view what, std::string_view name) {
  if (name.empty() || name.size() >= link::kNameLength) {
    throw std::runtime_error("The name of the " + std::string(what) + " '" + std::string(name) + "' must have 1 to " +
                             std::to_string(link::kNameLength - 1) + " bytes.");
  }
}

std::string wordsOf(std::string_view schema, std::uint32_t version, std::size_t size) {
  return std::string(schema) + " version " + std::to_string(version) + " (" + std::to_string(size) + " bytes)";
}

}  // namespace

namespace detail {

void store(ChannelSlot& slot, const void* value, std::size_t size) noexcept {
  const std::uint64_t number = slot.written.load(std::memory_order_relaxed);
  std::size_t place = 0;
  if (!placeOf(slot, number, size, place)) {
    return;
  }
  auto* at = &slot.data[place];
  at->store(wholeMark(number) - 1, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);
  const auto* from = static_cast<const std::byte*>(value);
  for (std::size_t left = size; left > 0;) {
    std::uint64_t word = 0;
    const std::size_t part = left < sizeof(word) ? left : sizeof(word);
    std::memcpy(&word, from, part);
    (++at)->store(word, std::memory_order_relaxed);
    from += part;
    left -= part;
  }
  slot.data[place].store(wholeMark(number), std::memory_order_release);
  slot.written.store(number + 1, std::memory_order_release);
}

Fetch fetch(const ChannelSlot& slot, std::uint64_t number, void* value, std::size_t size) noexcept {
  std::size_t place = 0;
  if (!placeOf(slot, number, size, place)) {
    return Fetch::kNone;
  }
  const auto* at = &slot.data[place];
  if (at->load(std::memory_order_acquire) != wholeMark(number)) {
    return Fetch::kOverwritten;
  }
  auto* to = static_cast<std::byte*>(value);
  for (std::size_t left = size; left > 0;) {
    const std::uint64_t word = (++at)->load(std::memory_order_relaxed);
    const std::size_t part = left < sizeof(word) ? left : sizeof(word);
    std::memcpy(to, &word, part);
    to += part;
    left -= part;
  }
  std::atomic_thread_fence(std::memory_order_acquire);
  return slot.data[place].load(std::memory_order_relaxed) == wholeMark(number) ? Fetch::kOk : Fetch::kOverwritten;
}

}  // namespace detail

ChannelDirectory::ChannelDirectory(ChannelSegment& own, std::vector<const ChannelSegment*> all)
    : own_(&own), all_(std::move(all)) {}

ChannelSlot& ChannelDirectory::open(const ChannelFacts& channel, std::uint32_t depth) {
  mustFit("channel", channel.name);
  mustFit("schema", channel.schema.name);
  const std::string quoted = "'" + std::string(channel.name) + "'";
  const std::size_t words = wordsOf(channel.size) + 1;
  if (depth == 0 || words * depth > kChannelWords) {
    throw std::runtime_error("The channel " + quoted + " cannot keep " + std::to_string(depth) + " values of " +
                             std::to_string(channel.size) + " bytes: there is room for " +
                             std::to_string(kChannelWords / words) + ".");
  }
  if (find(channel.name) != nullptr) {
    throw std::runtime_error("The channel " + quoted + " has a writer already, and can have only one.");
  }
  const auto free = std::find_if(own_->slots.begin(), own_->slots.end(),
                                 [](const ChannelSlot& slot) { return slot.id.load(std::memory_order_relaxed) == 0; });
  if (free == own_->slots.end()) {
    throw std::runtime_error("The channel " + quoted + " finds no room: one process can have " +
                             std::to_string(kMaxChannels) + ".");
  }
  link::assign(free->name, channel.name);
  link::assign(free->schema, channel.schema.name);
  free->version.store(channel.schema.version, std::memory_order_relaxed);
  free->size.store(static_cast<std::uint32_t>(channel.size), std::memory_order_relaxed);
  free->words.store(static_cast<std::uint32_t>(words), std::memory_order_relaxed);
  free->depth.store(depth, std::memory_order_relaxed);
  free->written.store(0, std::memory_order_relaxed);
  free->id.store(channel.id(), std::memory_order_release);
  return *free;
}

void ChannelDirectory::close(ChannelSlot& slot) noexcept { slot.id.store(0, std::memory_order_release); }

const ChannelSlot* ChannelDirectory::find(std::uint64_t id) const noexcept {
  for (const ChannelSegment* segment : all_) {
    for (const ChannelSlot& slot : segment->slots) {
      if (slot.id.load(std::memory_order_acquire) == id) {
        return &slot;
      }
    }
  }
  return nullptr;
}

const ChannelSlot* ChannelDirectory::find(std::string_view name) const noexcept {
  for (const ChannelSegment* segment : all_) {
    const auto found = std::find_if(segment->slots.begin(), segment->slots.end(),
                                    [&](const ChannelSlot& slot) { return isNamed(slot, name); });
    if (found != segment->slots.end()) return &*found;
  }
  return nullptr;
}

std::string ChannelDirectory::objection(const ChannelFacts& reader) const {
  const ChannelSlot* const slot = find(reader.name);
  if (slot == nullptr || slot->id.load(std::memory_order_acquire) == reader.id()) return {};
  const std::string written = wordsOf(link::view(slot->schema), slot->version.load(std::memory_order_relaxed),
                                      slot->size.load(std::memory_order_relaxed));
  return "The channel '" + std::string(reader.name) + "' carries " + written + ", and is read here as " +
         wordsOf(reader.schema.name, reader.schema.version, reader.size) +
         ": build its writer and its readers from the same definition.";
}

}  // namespace robotui::rt
