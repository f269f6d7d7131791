#include "robotui/rt/supervisor/rights.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>
#include <thread>

#include "robotui/rt/link/locked_memory.h"

namespace robotui::rt::supervisor {
namespace {

constexpr const char* kRemedy =
    " Allow it with a file /etc/security/limits.d/99-robotui-rt.conf that has the lines\n"
    "    @realtime - rtprio 98\n"
    "    @realtime - memlock unlimited\n"
    "  put yourself into that group (sudo groupadd -f realtime; sudo usermod -aG realtime $USER), and log in again.\n"
    "  In a container also --ulimit rtprio=98 --ulimit memlock=-1 --cap-add SYS_NICE are needed.\n"
    "  Or go on without, at your own risk: --allow-non-rt.";

// In a thread of its own, so that nothing of it stays.
int tryPriority(int priority) {
  int error = 0;
  std::thread([&] {
    sched_param param{};
    param.sched_priority = priority;
    error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &param);
  }).join();
  return error;
}

int tryDeadline(const link::Reservation& reservation) {
  int error = 0;
  std::thread([&] { error = link::scheduleByDeadline(reservation); }).join();
  return error;
}

int tryToLock() {
  const int error = link::lockMemory() ? 0 : errno;
  munlockall();
  return error;
}

}  // namespace

std::string lackOfRights(int priority, const link::Reservation& reservation) {
  if (const int error = priority == link::kByDeadline ? tryDeadline(reservation) : 0; error != 0) {
    return "This process may not run in real time: " + link::deadlineRefusal(reservation, error) +
           " Or go on without, at your own risk: --allow-non-rt.";
  }
  if (const int error = priority == link::kByDeadline ? 0 : tryPriority(priority); error != 0) {
    return "This process may not run in real time: priority " + std::to_string(priority) +
           " of SCHED_FIFO is refused (" + std::strerror(error) + ")." + kRemedy;
  }
  if (const int error = tryToLock(); error != 0) {
    return std::string("This process may not run in real time: it may not lock its memory (") + std::strerror(error) +
           ")." + kRemedy;
  }
  return {};
}

}  // namespace robotui::rt::supervisor
