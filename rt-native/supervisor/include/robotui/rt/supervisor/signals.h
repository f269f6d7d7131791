// The signals that the supervisor waits for, as a descriptor.
#pragma once

#include "robotui/rt/link/descriptor.h"

namespace robotui::rt::supervisor {

class Signals {
 public:
  // Blocks SIGINT, SIGTERM, SIGHUP and SIGCHLD for this thread and those it starts. Throws std::runtime_error.
  Signals();
  int get() const noexcept { return file_.get(); }

  // Takes what came: true where the process is to end.
  bool take() noexcept;

 private:
  link::Descriptor file_;
};

}  // namespace robotui::rt::supervisor
