// The library of a plugin: found, checked, loaded, and made an object of. Every way to fail is a whole sentence.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::host {

class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class PluginKind { kControl, kIo };

class PluginLibrary {
 public:
  // Looks for lib<type>.so in the folders, in order. Throws PluginError.
  PluginLibrary(const std::string& type, const std::vector<std::filesystem::path>& folders);
  ~PluginLibrary();
  PluginLibrary(const PluginLibrary&) = delete;
  PluginLibrary& operator=(const PluginLibrary&) = delete;

  const std::filesystem::path& file() const noexcept { return file_; }

  // An IO plugin comes as a control plugin whose loop is its run(). Throws PluginError, also for what a constructor
  // throws.
  std::unique_ptr<ControlPlugin> create(PluginKind kind) const;

  // Unloads. False where the library stays in memory all the same, so that a changed file would not be seen.
  bool unload() noexcept;

 private:
  void* symbol(const char* name) const;
  void checkAbi() const;
  void bind() const;

  std::string type_;
  std::filesystem::path file_;
  void* handle_;
};

// Where libraries are looked for: beside the executable, in ../lib of it (as built) and ../lib/robotui-rt (as
// installed), in ROBOTUI_RT_PLUGINS (folders separated by ':'), beside the configuration.
std::vector<std::filesystem::path> pluginFolders(const std::filesystem::path& config);

}  // namespace robotui::rt::host
