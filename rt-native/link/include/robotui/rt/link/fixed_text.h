// Text of bounded length, held in place: what real-time threads make and hand on without asking the heap for memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace robotui::rt::link {

// What does not fit is cut.
template <std::size_t kLength>
class FixedText {
 public:
  FixedText() noexcept = default;
  FixedText(const FixedText& other) noexcept { assign(other.view()); }
  FixedText& operator=(const FixedText& other) noexcept {
    if (this != &other) assign(other.view());
    return *this;
  }
  ~FixedText() = default;

  FixedText& assign(std::string_view from) noexcept {
    length_ = 0;
    return append(from);
  }
  FixedText& append(std::string_view from) noexcept {
    const std::size_t part = std::min(from.size(), kLength - length_);
    std::copy_n(from.data(), part, text_.data() + length_);
    length_ += part;
    return *this;
  }
  std::string_view view() const noexcept { return {text_.data(), length_}; }

 private:
  std::size_t length_ = 0;
  std::array<char, kLength> text_;  // only the first length_ of it are ever read
};

}  // namespace robotui::rt::link
