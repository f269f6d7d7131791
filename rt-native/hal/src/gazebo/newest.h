// The newest value that passes between an ordinary thread and the one of real time, in either direction.
#pragma once

#include <atomic>
#include <type_traits>

#include "robotui/rt/link/seqlock.h"

namespace robotui::rt::hal::gazebo {

// One writer at a time, which never waits.
template <class T>
class Newest {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(link::Word) == 0);

 public:
  void write(const T& value) noexcept {
    link::lockedWrite(sequence_, [&]() noexcept { link::relaxedCopyIn(&value_, &value, sizeof(T)); });
  }

  // `last` is what this reader had: 0 at first. Where it is not kNew, nothing in `into` is worth anything but after
  // kSame.
  link::Read read(T& into, std::uint64_t& last) const noexcept {
    return link::readLocked(sequence_, value_, into, sizeof(T), last);
  }

 private:
  std::atomic<std::uint64_t> sequence_{0};
  T value_{};
};

}  // namespace robotui::rt::hal::gazebo
