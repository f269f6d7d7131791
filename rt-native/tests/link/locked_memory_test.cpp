#include "robotui/rt/link/locked_memory.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <fstream>

#include <gtest/gtest.h>

namespace robotui::rt::link {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;
constexpr uid_t kOrdinaryUser = 65534;

std::size_t ownSize() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  file >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

// Of an ordinary user whose limit is a little above what the process has, or what it is where that is less: 0 as it
// should be.
int lockWithLittleRoom() {
  rlimit limit{};
  ::getrlimit(RLIMIT_MEMLOCK, &limit);
  limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(limit.rlim_max, ownSize() + 16 * kMiB);
  if (::setrlimit(RLIMIT_MEMLOCK, &limit) != 0) return 1;
  if (::getuid() == 0 && ::setuid(kOrdinaryUser) != 0) return 2;
  if (lockMemory()) return 3;
  return ::mmap(nullptr, 32 * kMiB, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? 4 : 0;
}

TEST(LockedMemory, ALimitLocksNothingAndKeepsNothingFromBeingMapped) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers lock no memory";
#endif
  const pid_t child = ::fork();
  if (child == 0) ::_exit(lockWithLittleRoom());
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace robotui::rt::link
