#include "text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace robotui::rt::config {
namespace {

void mustBeReadable(const std::filesystem::path& file, const Place& wanted, const std::string& what,
                    std::size_t largest) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const std::string name = what + " '" + file.string() + "' ";
  if (!std::filesystem::exists(status)) {
    throw ConfigError(
        wanted, name + "does not exist; write the path of the file, relative to the one that names it or absolute");
  }
  if (!std::filesystem::is_regular_file(status)) throw ConfigError(wanted, name + "is not a file");
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw ConfigError(wanted, name + "cannot be read: " + error.message());
  if (size > largest) {
    throw ConfigError(
        wanted, name + "has " + std::to_string(size) + " bytes; at most " + std::to_string(largest) + " are read");
  }
}

}  // namespace

std::string readTextFile(const std::filesystem::path& file, const Place& wanted, const std::string& what,
                         std::size_t largest) {
  mustBeReadable(file, wanted, what, largest);
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ConfigError(wanted, what + " '" + file.string() + "' cannot be opened: " + std::strerror(errno));
  std::string text(largest + 1, '\0');  // it may have grown since it was asked for its size
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > largest) throw ConfigError(wanted, what + " '" + file.string() + "' is too large");
  return text;
}

}  // namespace robotui::rt::config
