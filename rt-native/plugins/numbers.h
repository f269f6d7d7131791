// Numbers of a command, read without allocating.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace robotui::rt::plugins {

// Takes the first word off.
inline std::string_view takeWord(std::string_view& words) noexcept {
  words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
  const std::string_view word = words.substr(0, words.find(' '));
  words.remove_prefix(word.size());
  words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
  return word;
}

// How many finite numbers, separated by spaces, the words are; -1 where they are something else or more than `most`.
inline int readNumbers(std::string_view words, double* into, int most) noexcept {
  int count = 0;
  const char* at = words.data();
  const char* const end = words.data() + words.size();
  while (true) {
    while (at != end && *at == ' ') ++at;
    if (at == end) return count;
    if (count == most) return -1;
    const auto [next, error] = std::from_chars(at, end, into[count]);
    if (error != std::errc{} || !std::isfinite(into[count]) || (next != end && *next != ' ')) return -1;
    at = next;
    ++count;
  }
}

}  // namespace robotui::rt::plugins
