#include "draft_packages.h"

#include <algorithm>
#include <set>

namespace robotui::rt::config {
namespace {

constexpr std::string_view kScheme = "package://";
constexpr std::size_t kMostPackages = 100;

std::set<std::string> namesIn(const std::string& text) {
  std::set<std::string> names;
  for (auto at = text.find(kScheme); at != std::string::npos && names.size() < kMostPackages;
       at = text.find(kScheme, at)) {
    at += kScheme.size();
    const auto end = text.find_first_of("/\"'<", at);
    if (end != std::string::npos && end > at && text[at] != '.') names.insert(text.substr(at, end - at));
  }
  return names;
}

std::filesystem::path folderOf(const std::string& name, const std::filesystem::path& urdf) {
  std::error_code none;
  for (auto folder = urdf.parent_path(); folder != folder.root_path(); folder = folder.parent_path()) {
    if (folder.filename() == name) return folder.parent_path();
    if (std::filesystem::is_directory(folder / name, none)) return folder;
  }
  return {};
}

}  // namespace

DraftPackages draftPackages(const std::filesystem::path& urdf, const std::string& text) {
  DraftPackages result;
  for (const std::string& name : namesIn(text)) {
    const std::string folder = folderOf(name, urdf).string();
    if (folder.empty())
      result.not_found.push_back(name);
    else if (std::find(result.folders.begin(), result.folders.end(), folder) == result.folders.end())
      result.folders.push_back(folder);
  }
  return result;
}

}  // namespace robotui::rt::config
