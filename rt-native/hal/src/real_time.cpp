#include "real_time.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include "robotui/rt/link/locked_memory.h"

namespace robotui::rt::hal {

namespace {

constexpr std::size_t kStack = 256 * 1024;
constexpr std::size_t kPage = 4096;

constexpr const char* kRemedy =
    " Give the user 'rtprio 99' and 'memlock unlimited' in /etc/security/limits.conf and log in again, or the program "
    "CAP_SYS_NICE and "
    "CAP_IPC_LOCK (setcap cap_sys_nice,cap_ipc_lock+ep), or start with --allow-non-rt.";

bool isRealTimeOff() {
  std::ifstream file("/proc/sys/kernel/sched_rt_runtime_us");
  long runtime = -1;
  file >> runtime;
  return runtime == 0;
}

}  // namespace

// malloc neither returns memory to the system nor maps large pieces by themselves: both would mean page faults later.
Refusal lockMemory() {
  ::mallopt(M_TRIM_THRESHOLD, -1);
  ::mallopt(M_MMAP_MAX, 0);
  if (link::lockMemory()) return std::nullopt;
  return std::string("Memory cannot be locked: ") + std::strerror(errno) + "." + kRemedy;
}

Refusal scheduleFifo(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
  if (error == 0) return std::nullopt;
  const std::string what = "The loop cannot run with SCHED_FIFO and priority " + std::to_string(priority) + ": " +
                           std::strerror(error) + ".";
  if (isRealTimeOff())
    return what + " The kernel gives no time to real time: sysctl kernel.sched_rt_runtime_us=950000.";
  return what + kRemedy;
}

Refusal scheduleDeadline(const link::Reservation& reservation) {
  const int error = link::scheduleByDeadline(reservation);
  if (error == 0) return std::nullopt;
  return "The loop cannot keep its time: " + link::deadlineRefusal(reservation, error);
}

Refusal pinTo(int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (core >= 0 && core < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(core), &set);
  const int error = ::pthread_setaffinity_np(::pthread_self(), sizeof(set), &set);
  if (error == 0) return std::nullopt;
  return "The loop cannot be kept on CPU " + std::to_string(core) + ": " + std::strerror(error) +
         ". Write another core_id, or none.";
}

void prepareThread() noexcept {
  ::prctl(PR_SET_TIMERSLACK, 1UL);
  std::array<char, kStack> stack;
  for (std::size_t i = 0; i < kStack; i += kPage) static_cast<volatile char&>(stack[i]) = 0;
}

long pageFaults() noexcept {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt + usage.ru_majflt;
}

}  // namespace robotui::rt::hal
