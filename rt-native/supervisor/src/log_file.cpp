#include "robotui/rt/supervisor/log_file.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <string>

#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 64u << 20;  // a plugin that logs in every cycle must not fill the disk
constexpr std::size_t kMaxLine = 4096;        // on stderr: as much as a pipe takes at once

// A terminal that was stopped, or a pipe that nobody empties, must not keep the supervisor; one that nobody has open
// must not end it.
bool isWritable(int fd) noexcept {
  pollfd polled{fd, POLLOUT, 0};
  return ::poll(&polled, 1, 0) > 0 && (polled.revents & (POLLOUT | POLLERR | POLLHUP)) == POLLOUT;
}

std::string timeOfDay() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  tm local{};
  localtime_r(&now.tv_sec, &local);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%H:%M:%S", &local);
  const std::string millis = std::to_string(1000 + now.tv_nsec / 1'000'000);
  return std::string(text.data(), length) + "." + millis.substr(1);
}

// The log of the run before stays as FILE.old.
std::FILE* openFresh(const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  fs::rename(file, fs::path(file).concat(".old"), error);
  return std::fopen(file.c_str(), "we");
}

}  // namespace

LogFile::LogFile(const fs::path& file, bool verbose) : file_(openFresh(file)), verbose_(verbose) {
  if (file_ == nullptr) {
    warn("The log " + file.string() + " cannot be written: it is only here.");
  }
}

void LogFile::relay(std::string_view whose, std::string_view words) {
  const auto [level, line] = link::splitWord(words);
  const bool known = level == "info" || level == "warn" || level == "error";
  write(known ? level : "info", (whose.empty() ? "" : std::string(whose) + ": ") + std::string(line));
}

void LogFile::write(std::string_view level, std::string_view line) {
  const std::string text = timeOfDay() + " " + std::string(level) +
                           std::string(level.size() < 6 ? 6 - level.size() : 0, ' ') + " " + std::string(line) + "\n";
  if (isWritable(STDERR_FILENO)) {
    std::fputs(text.substr(0, kMaxLine).c_str(), stderr);
  }
  if (file_ != nullptr && written_ < kMaxBytes) {
    std::fputs(text.c_str(), file_.get());
    std::fflush(file_.get());
    written_ += text.size();
  }
}

fs::path logFilePath(std::string_view name) {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base =
      state != nullptr && *state != 0 ? fs::path(state) : fs::path(home == nullptr ? "/tmp" : home) / ".local/state";
  return base / "robotui" / ("rt-" + std::string(name) + ".log");
}

}  // namespace robotui::rt::supervisor
