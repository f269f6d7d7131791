// Plain numbers in shared memory that one process writes and others read: never torn, in no order with anything else.
#pragma once

#include <cstddef>
#include <cstdint>

namespace robotui::rt::link {

template <class T>
T relaxedLoad(const T& from) noexcept {
  T value;
  __atomic_load(&from, &value, __ATOMIC_RELAXED);
  return value;
}

template <class T>
void relaxedStore(T& into, T value) noexcept {
  __atomic_store(&into, &value, __ATOMIC_RELAXED);
}

// Only for the one writer: no other may write between its load and its store.
template <class T>
void relaxedAdd(T& into, T amount) noexcept {
  relaxedStore(into, static_cast<T>(relaxedLoad(into) + amount));
}

// Copies whole words of eight bytes, each at once. The data may be of any type: that is what the attribute is for.
using Word = std::uint64_t __attribute__((may_alias));

inline void relaxedCopyIn(void* shared, const void* local, std::size_t bytes) noexcept {
  auto* to = static_cast<Word*>(shared);
  const auto* from = static_cast<const Word*>(local);
  for (std::size_t i = 0; i < bytes / sizeof(Word); ++i) __atomic_store_n(to + i, from[i], __ATOMIC_RELAXED);
}

inline void relaxedCopyOut(void* local, const void* shared, std::size_t bytes) noexcept {
  auto* to = static_cast<Word*>(local);
  const auto* from = static_cast<const Word*>(shared);
  for (std::size_t i = 0; i < bytes / sizeof(Word); ++i) to[i] = __atomic_load_n(from + i, __ATOMIC_RELAXED);
}

// A copy of what stands in shared memory, such as a histogram or statistics: each number whole, though not all of one
// moment.
template <class T>
T relaxedCopy(const T& shared) noexcept {
  static_assert(sizeof(T) % sizeof(Word) == 0 && alignof(T) == alignof(Word));
  T local;
  relaxedCopyOut(&local, &shared, sizeof(T));
  return local;
}

}  // namespace robotui::rt::link
