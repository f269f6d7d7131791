// A sequence lock: one writer that never waits, any number of readers that try again when the writer came in between.
//
// The writer makes the sequence odd, writes, makes it even. A fence keeps the data behind the odd number, and one keeps
// the second look of the reader behind its data; the words of the data are relaxed atomics, so that no access is a data
// race.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "robotui/rt/link/relaxed.h"

// Thread sanitizer does not model fences. It need not here: nothing that it watches depends on them, since all accesses
// are atomic.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wtsan"
#endif

namespace robotui::rt::link {

template <class Copy>
void lockedWrite(std::atomic<std::uint64_t>& sequence, Copy&& copy) noexcept {
  const std::uint64_t even = sequence.load(std::memory_order_relaxed) & ~std::uint64_t{1};
  sequence.store(even + 1, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);
  copy();
  sequence.store(even + 2, std::memory_order_release);
}

// One try: the even sequence of what was copied, or 0 where nothing was written yet or the writer came in between.
template <class Copy>
std::uint64_t lockedRead(const std::atomic<std::uint64_t>& sequence, Copy&& copy) noexcept {
  const std::uint64_t before = sequence.load(std::memory_order_acquire);
  if (before == 0 || (before & 1) != 0) return 0;
  copy();
  std::atomic_thread_fence(std::memory_order_acquire);
  return sequence.load(std::memory_order_relaxed) == before ? before : 0;
}

// What a read found.
enum class Read : std::uint8_t {
  kNew,   // something that this reader has not had
  kSame,  // nothing newer than the last; the copy is untouched
  kNone,  // nothing was written yet
  kBusy   // the writer came in between at every try (or died while it wrote); the copy is worth nothing
};

inline constexpr int kReadTries = 16;

// One read with tries, of the first `bytes`; `last` is the sequence that this reader had.
template <class Data>
Read readLocked(const std::atomic<std::uint64_t>& sequence, const Data& shared, Data& into, std::size_t bytes,
                std::uint64_t& last) noexcept {
  const std::uint64_t first = sequence.load(std::memory_order_acquire);
  if (first == 0) return Read::kNone;
  if (first == last) return Read::kSame;
  for (int i = 0; i < kReadTries; ++i) {
    const std::uint64_t read = lockedRead(sequence, [&]() noexcept { relaxedCopyOut(&into, &shared, bytes); });
    if (read == 0) continue;
    last = read;
    return Read::kNew;
  }
  return Read::kBusy;
}

}  // namespace robotui::rt::link

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
