// Words of a request, and lists of names in a sentence.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace robotui::rt::link {

// "a b c": the first word, and the rest behind the space.
constexpr std::pair<std::string_view, std::string_view> splitWord(std::string_view words) noexcept {
  const std::size_t space = words.find(' ');
  return space == std::string_view::npos ? std::pair{words, std::string_view()}
                                         : std::pair{words.substr(0, space), words.substr(space + 1)};
}

// Calls `each` with every word; several spaces are one.
template <typename Each>
void forEachWord(std::string_view words, Each&& each) {
  while (!words.empty()) {
    const auto [word, rest] = splitWord(words);
    if (!word.empty()) each(word);
    words = rest;
  }
}

inline bool containsWord(std::string_view words, std::string_view wanted) {
  bool found = false;
  forEachWord(words, [&](std::string_view word) { found = found || word == wanted; });
  return found;
}

// "a, b, c": the names of all items, or `none`. `name` says the name of one.
template <typename Items, typename Name = std::identity>
std::string listed(const Items& items, const Name& name = {}, std::string_view none = {}) {
  std::string text;
  for (const auto& item : items) {
    if (!text.empty()) text += ", ";
    text += std::invoke(name, item);
  }
  return text.empty() ? std::string(none) : text;
}

}  // namespace robotui::rt::link
