#include "robotui/rt/link/descriptor.h"

#include <unistd.h>

namespace robotui::rt::link {

void Descriptor::reset(int fd) noexcept {
  if (fd_ >= 0) ::close(fd_);
  fd_ = fd;
}

}  // namespace robotui::rt::link
