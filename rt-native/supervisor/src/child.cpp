#include "robotui/rt/supervisor/child.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace robotui::rt::supervisor {
namespace {

std::string describeEnd(int status) {
  if (WIFEXITED(status)) {
    return "ended by itself with code " + std::to_string(WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU) {
    return "was ended because a thread of it computed without a pause";
  }
  return std::string("was ended by signal ") + std::to_string(signal) + " (" + strsignal(signal) + ")";
}

// Between fork and exec only what is safe in a signal handler.
[[noreturn]] void becomeChild(pid_t parent, int on_orphan, const char* program, char* const* arguments) {
  prctl(PR_SET_PDEATHSIG, on_orphan);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (getppid() == parent) {
    execv(program, arguments);
  }
  _exit(127);
}

}  // namespace

void Child::spawn(const std::filesystem::path& program, std::vector<std::string> arguments, int on_orphan) {
  auto [mine, its] = link::Socket::pair();
  its.inheritable();
  arguments.insert(arguments.begin(), program.string());
  arguments.insert(arguments.end(), {"--control", std::to_string(its.get())});
  std::vector<char*> raw;
  raw.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) {
    raw.push_back(argument.data());
  }
  raw.push_back(nullptr);
  if (access(program.c_str(), X_OK) != 0) {
    throw std::runtime_error("There is no program " + program.string() + ": robotui-rt is not whole, build it again.");
  }
  const pid_t self = getpid();
  const pid_t pid = fork();
  if (pid < 0) {
    throw std::runtime_error("No process can be started for " + program.string() + ": " + std::strerror(errno) + ".");
  }
  if (pid == 0) {
    becomeChild(self, on_orphan, program.c_str(), raw.data());
  }
  pid_ = pid;
  socket_ = std::move(mine);
  reason_.clear();
}

void Child::kill(const std::string& reason) {
  if (isAlive() && reason_.empty()) {
    reason_ = reason;
    ::kill(pid_, SIGKILL);
  }
}

void Child::kill() noexcept {
  if (isAlive()) {
    ::kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }
}

std::optional<std::string> Child::end() {
  int status = 0;
  if (!isAlive() || waitpid(pid_, &status, WNOHANG) != pid_) {
    return std::nullopt;
  }
  pid_ = -1;
  return reason_.empty() ? describeEnd(status) : "was ended because " + reason_;
}

std::filesystem::path programBeside(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / name;
}

}  // namespace robotui::rt::supervisor
