#include "robotui/rt/link/locked_memory.h"

#include <sys/mman.h>

#include <cerrno>
#include <cstddef>

namespace robotui::rt::link {
namespace {

// More than any of our processes has. It is never touched, so that asking for it costs nothing.
constexpr std::size_t kPlenty = std::size_t{256} << 20;

bool isThereRoom() noexcept {
  void* const room = ::mmap(nullptr, kPlenty, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, kPlenty);
  return true;
}

}  // namespace

bool lockMemory() noexcept {
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0) return false;
  if (isThereRoom()) return true;
  const int why = errno;
  ::munlockall();
  errno = why;
  return false;
}

}  // namespace robotui::rt::link
