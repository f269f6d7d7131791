#include "robotui/rt/supervisor/signals.h"

#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace robotui::rt::supervisor {
namespace {

int openSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
    sigaddset(&set, signal);
  }
  sigprocmask(SIG_BLOCK, &set, nullptr);
  return signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

}  // namespace

Signals::Signals() : file_(openSignals()) {
  if (!file_.isOpen()) {
    throw std::runtime_error(std::string("Signals cannot be waited for: ") + std::strerror(errno) + ".");
  }
}

bool Signals::take() noexcept {
  bool end = false;
  signalfd_siginfo info{};
  while (::read(file_.get(), &info, sizeof(info)) == static_cast<ssize_t>(sizeof(info))) {
    end = end || info.ssi_signo != static_cast<std::uint32_t>(SIGCHLD);
  }
  return end;
}

}  // namespace robotui::rt::supervisor
