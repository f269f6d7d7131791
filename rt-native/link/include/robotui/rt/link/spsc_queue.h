// A queue between two threads, one that puts in and one that takes out, neither of which ever waits.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

namespace robotui::rt::link {

template <typename T, std::size_t kSize>
class SpscQueue {
 public:
  bool push(const T& value) noexcept {  // false: full
    const std::size_t in = in_.load(std::memory_order_relaxed);
    if (in - out_.load(std::memory_order_acquire) == kSize) {
      return false;
    }
    values_[in % kSize] = value;
    in_.store(in + 1, std::memory_order_release);
    return true;
  }

  bool pop(T& value) noexcept {  // false: empty
    const std::size_t out = out_.load(std::memory_order_relaxed);
    if (out == in_.load(std::memory_order_acquire)) {
      return false;
    }
    value = values_[out % kSize];
    out_.store(out + 1, std::memory_order_release);
    return true;
  }

 private:
  std::array<T, kSize> values_{};
  alignas(64) std::atomic<std::size_t> in_{0};
  alignas(64) std::atomic<std::size_t> out_{0};
};

}  // namespace robotui::rt::link
