// Counts what a thread asks of the heap while it should not. In an executable that links rt::malloc_counter; elsewhere
// it counts nothing.
#pragma once

#include <cstdint>

namespace robotui::rt::link {

struct AllocationCount {
  bool counting = false;
  std::uint64_t calls = 0;  // of malloc, free and their kin, while counting
};

// Of the calling thread.
AllocationCount& allocationCount() noexcept;

class CountAllocations {
 public:
  CountAllocations() noexcept { allocationCount().counting = true; }
  ~CountAllocations() { allocationCount().counting = false; }
  CountAllocations(const CountAllocations&) = delete;
  CountAllocations& operator=(const CountAllocations&) = delete;
};

}  // namespace robotui::rt::link
