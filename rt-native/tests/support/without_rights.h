// What a user without real-time rights may do, also where tests run as root.
#pragma once

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace robotui::rt {

// Between fork and exec: the next program of this process can have neither priorities nor locked memory. Where a
// capability cannot be dropped, the process has not the right to give it on, either.
inline void dropRealTimeRights() noexcept {
  constexpr rlimit kNone{0, 0};
  ::setrlimit(RLIMIT_RTPRIO, &kNone);
  ::setrlimit(RLIMIT_MEMLOCK, &kNone);
  ::prctl(PR_CAPBSET_DROP, CAP_SYS_NICE, 0, 0, 0);
  ::prctl(PR_CAPBSET_DROP, CAP_IPC_LOCK, 0, 0, 0);
  ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
}

}  // namespace robotui::rt
