#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <sys/stat.h>
#include <unistd.h>

#include "robotui/rt/link/socket.h"

namespace robotui::rt::link {

namespace {

std::filesystem::path folderPath() {
  const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime == '/') return std::filesystem::path(runtime) / "robotui-rt";
  return "/tmp/robotui-rt-" + std::to_string(::getuid());
}

bool isFileName(std::string_view name) noexcept {
  return !name.empty() && name.size() < 64 && name != "." && name != ".." && name.find('/') == std::string_view::npos &&
         name.find('\0') == std::string_view::npos;
}

}  // namespace

// /tmp is everybody's: what another made there first is not used.
std::filesystem::path socketFolder() {
  std::filesystem::path folder = folderPath();
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) {
    throw SocketError("The folder " + folder.string() + " cannot be made: " + std::strerror(errno) + ".");
  }
  struct stat status {};
  if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != ::getuid() ||
      (status.st_mode & 077) != 0) {
    throw SocketError("The folder " + folder.string() +
                      " must be yours alone (mode 0700): remove it or set XDG_RUNTIME_DIR.");
  }
  return folder;
}

std::filesystem::path socketPath(std::string_view robot) {
  if (!isFileName(robot))
    throw SocketError("'" + std::string(robot) + "' cannot be the name of a robot: write one without '/'.");
  return socketFolder() / (std::string(robot) + ".sock");
}

}  // namespace robotui::rt::link
