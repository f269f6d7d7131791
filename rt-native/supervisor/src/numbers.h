// Descriptors as they are handed to another process: by number, while their owner keeps them.
#pragma once

#include <vector>

#include "robotui/rt/link/descriptor.h"

namespace robotui::rt::supervisor {

inline std::vector<int> numbersOf(const std::vector<link::Descriptor>& descriptors) {
  std::vector<int> numbers;
  numbers.reserve(descriptors.size());
  for (const auto& descriptor : descriptors) numbers.push_back(descriptor.get());
  return numbers;
}

}  // namespace robotui::rt::supervisor
