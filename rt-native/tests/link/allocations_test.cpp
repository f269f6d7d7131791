#include "robotui/rt/link/allocations.h"

#include <memory>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace robotui::rt::link {
namespace {

// Kept from being optimised away.
std::unique_ptr<int>& kept() {
  static std::unique_ptr<int> value;
  return value;
}

TEST(Allocations, are_counted_in_the_thread_and_scope_that_asks) {
  const std::uint64_t before = allocationCount().calls;
  kept() = std::make_unique<int>(1);
  EXPECT_EQ(allocationCount().calls, before);
  {
    const CountAllocations count;
    kept() = std::make_unique<int>(2);
  }
  EXPECT_EQ(allocationCount().calls, before + 2);  // one more, and the old one less
  try {
    const CountAllocations count;
    throw std::runtime_error("what is thrown lies in the heap");
  } catch (const std::runtime_error&) {
    EXPECT_GT(allocationCount().calls, before + 2);
  }
  {
    const CountAllocations count;
    std::jthread([] { EXPECT_FALSE(allocationCount().counting); });
  }
}

}  // namespace
}  // namespace robotui::rt::link
