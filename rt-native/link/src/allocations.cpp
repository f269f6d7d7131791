#include "robotui/rt/link/allocations.h"

namespace robotui::rt::link {
namespace {

constinit thread_local AllocationCount count;

}  // namespace

AllocationCount& allocationCount() noexcept { return count; }

}  // namespace robotui::rt::link
