#include "robotui/rt/supervisor/log_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string>

#include "../link/temporary_folder.h"

namespace robotui::rt::supervisor {
namespace {

// The process's stderr is a pipe that is full and that nobody reads.
class StuckTerminal {
 public:
  StuckTerminal() : old_(::dup(STDERR_FILENO)) {
    EXPECT_EQ(::pipe(ends_.data()), 0);
    ::fcntl(ends_[1], F_SETFL, O_NONBLOCK);
    const std::array<char, 4096> bytes{};
    while (::write(ends_[1], bytes.data(), bytes.size()) > 0) {
    }
    ::fcntl(ends_[1], F_SETFL, 0);
    ::dup2(ends_[1], STDERR_FILENO);
  }
  ~StuckTerminal() {
    ::dup2(old_, STDERR_FILENO);
    for (const int fd : {old_, ends_[0], ends_[1]}) ::close(fd);
  }
  StuckTerminal(const StuckTerminal&) = delete;
  StuckTerminal& operator=(const StuckTerminal&) = delete;

 private:
  int old_;
  std::array<int, 2> ends_{};
};

TEST(LogFileTest, ATerminalThatIsStoppedKeepsNobody) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "log";
  LogFile log(file, false);
  {
    const StuckTerminal stuck;
    for (int i = 0; i < 100; ++i) log.warn("nobody reads this");
    log.warn("the last line");
  }
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("the last line"), std::string::npos);
}

}  // namespace
}  // namespace robotui::rt::supervisor
