// The log of robotui-rt and all its processes: to stderr and to a file.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace robotui::rt::supervisor {

class LogFile {
 public:
  // Without a file where that cannot be written: said once on stderr.
  LogFile(const std::filesystem::path& file, bool verbose);

  void detail(std::string_view line) {
    if (verbose_) write("detail", line);
  }
  void info(std::string_view line) { write("info", line); }
  void warn(std::string_view line) { write("warn", line); }
  void error(std::string_view line) { write("error", line); }
  void write(std::string_view level, std::string_view line);

  // What another process wants to be logged: "LEVEL LINE", behind its name where that is not empty.
  void relay(std::string_view whose, std::string_view words);

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  bool verbose_;
  std::size_t written_ = 0;
};

// $XDG_STATE_HOME/robotui/rt-NAME.log, or the same under ~/.local/state.
std::filesystem::path logFilePath(std::string_view name);

}  // namespace robotui::rt::supervisor
