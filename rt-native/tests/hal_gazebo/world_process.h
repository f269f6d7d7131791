// The model of a world in a process of its own, so that all goes over the wire.
#pragma once

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace robotui::rt {

// A name that no other test on this network has.
inline std::string ownPartition() {
  static int count = 0;
  return "robotui-test-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
}

class WorldProcess {
 public:
  // `options` are KEY=VALUE.
  explicit WorldProcess(const std::vector<std::string>& options) {
    int down[2];
    int up[2];
    if (::pipe(down) != 0 || ::pipe(up) != 0) throw std::runtime_error("no pipe");
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(down[0], STDIN_FILENO);
      ::dup2(up[1], STDOUT_FILENO);
      for (const int end : {down[0], down[1], up[0], up[1]}) ::close(end);
      run(options);
    }
    ::close(down[0]);
    ::close(up[1]);
    to_.reset(::fdopen(down[1], "w"));
    from_.reset(::fdopen(up[0], "r"));
    if (answer() != "ready") throw std::runtime_error("the world did not start");
  }
  ~WorldProcess() {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  WorldProcess(const WorldProcess&) = delete;
  WorldProcess& operator=(const WorldProcess&) = delete;

  std::string say(const std::string& line) {
    std::fprintf(to_.get(), "%s\n", line.c_str());
    std::fflush(to_.get());
    return answer();
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };

  [[noreturn]] static void run(const std::vector<std::string>& options) {
    ::setenv("IGN_IP", "127.0.0.1", 1);
    std::vector<std::string> words{GAZEBO_WORLD};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> raw;
    for (std::string& word : words) raw.push_back(word.data());
    raw.push_back(nullptr);
    ::execv(raw[0], raw.data());
    ::_exit(127);
  }

  std::string answer() {
    char line[512];
    if (std::fgets(line, sizeof(line), from_.get()) == nullptr) throw std::runtime_error("the world has ended");
    const std::string text = line;
    return text.substr(0, text.find('\n'));
  }

  pid_t pid_ = -1;
  std::unique_ptr<std::FILE, Close> to_;
  std::unique_ptr<std::FILE, Close> from_;
};

}  // namespace robotui::rt
