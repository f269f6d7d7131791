// Lines for the user from threads that must not wait.
#pragma once

#include <string_view>

namespace robotui::rt {

// Writes lines to the log from any thread, without blocking or allocating: a line that finds the queue full is counted
// instead, and a long one is cut.
class RtLog {
 public:
  virtual ~RtLog() = default;
  virtual void info(std::string_view line) noexcept = 0;
  virtual void warn(std::string_view line) noexcept = 0;
  virtual void error(std::string_view line) noexcept = 0;
};

}  // namespace robotui::rt
