#include "robotui/rt/host/plugin_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "robotui/rt/link/words.h"
#include "robotui/rt/plugin/io_plugin.h"

namespace robotui::rt::host {
namespace {

namespace fs = std::filesystem;

class IoAdapter final : public ControlPlugin {
 public:
  explicit IoAdapter(std::unique_ptr<IoPlugin> plugin) : plugin_(std::move(plugin)) {}
  bool init_control_plugin(Setup& setup) override { return plugin_->init(setup); }
  PluginRole role() const noexcept override { return PluginRole::kObserver; }
  RtStatus control_loop(double time, double period) override {
    plugin_->run(time, period);
    return RtStatus::ok();
  }
  bool on_command(std::string_view words) override { return plugin_->on_command(words); }
  std::string_view status() const noexcept override { return plugin_->status(); }
  void close() override { plugin_->close(); }

 private:
  std::unique_ptr<IoPlugin> plugin_;
};

fs::path findLibrary(const std::string& type, const std::vector<fs::path>& folders) {
  const std::string name = "lib" + type + ".so";
  if (type.empty() || type.find('/') != std::string::npos) {
    throw PluginError("'" + type + "' is no name of a plugin: write the name of its class.");
  }
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    if (fs::exists(folder / name, ignored)) {
      return folder / name;
    }
  }
  throw PluginError("There is no " + name + " in " +
                    link::listed(folders, [](const fs::path& folder) { return folder.string(); }) +
                    ". Build it, or name its folder in ROBOTUI_RT_PLUGINS.");
}

fs::path executableFolder() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

// The message of the exception that is being handled.
std::string currentMessage() {
  try {
    throw;
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "something that is no std::exception";
  }
}

template <typename Made>
std::unique_ptr<Made> make(void* factory, const fs::path& file) {
  Made* made = nullptr;
  try {
    made = reinterpret_cast<Made* (*)()>(factory)();
  } catch (...) {
    throw PluginError("The constructor of the plugin in " + file.string() + " threw: " + currentMessage());
  }
  if (made == nullptr) {
    throw PluginError(file.string() + " made no plugin.");
  }
  return std::unique_ptr<Made>(made);
}

}  // namespace

PluginLibrary::PluginLibrary(const std::string& type, const std::vector<fs::path>& folders)
    : type_(type), file_(findLibrary(type, folders)), handle_(dlopen(file_.c_str(), RTLD_LAZY | RTLD_LOCAL)) {
  if (handle_ == nullptr) {
    throw PluginError(file_.string() + " cannot be loaded: " + dlerror());
  }
  try {
    checkAbi();
    bind();
  } catch (...) {
    dlclose(handle_);
    throw;
  }
}

PluginLibrary::~PluginLibrary() { unload(); }

void* PluginLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

void PluginLibrary::checkAbi() const {
  void* abi = symbol("robotui_rt_plugin_abi");
  if (abi == nullptr) {
    throw PluginError(file_.string() + " is no plugin: end its source with ROBOTUI_RT_PLUGIN(" + type_ + ").");
  }
  const std::uint32_t has = reinterpret_cast<std::uint32_t (*)()>(abi)();
  if (has != kPluginAbi) {
    std::ostringstream what;
    what << file_.string() << " was built for version " << has << " of the plugin interface, and this is version "
         << kPluginAbi << ": build it again.";
    throw PluginError(what.str());
  }
  void* facts = symbol("robotui_rt_plugin_facts");
  if (facts == nullptr) {
    throw PluginError(file_.string() + " does not say what it was built with: end its source with ROBOTUI_RT_PLUGIN(" +
                      type_ + ").");
  }
  const std::string difference =
      link::abiDifference(file_.string(), reinterpret_cast<const link::AbiFact* (*)()>(facts)(), kPluginFacts);
  if (!difference.empty()) {
    throw PluginError(difference);
  }
}

// All that it calls must be there before it runs. Not before it was checked: a library that was built another way lacks
// what it asks for, and the reason says more than the name of a symbol.
void PluginLibrary::bind() const {
  void* const again = dlopen(file_.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (again == nullptr) {
    throw PluginError(file_.string() + " cannot be loaded: " + dlerror());
  }
  dlclose(again);
}

std::unique_ptr<ControlPlugin> PluginLibrary::create(PluginKind kind) const {
  void* control = symbol("robotui_rt_plugin_create");
  void* io = symbol("robotui_rt_io_plugin_create");
  if (kind == PluginKind::kControl && control == nullptr) {
    throw PluginError(file_.string() +
                      (io != nullptr ? " is an IO plugin: name it under io_plugins."
                                     : " exports no robotui_rt_plugin_create: end its source with ROBOTUI_RT_PLUGIN(" +
                                           type_ + ")."));
  }
  if (kind == PluginKind::kIo && io == nullptr) {
    throw PluginError(file_.string() + " is no IO plugin: end its source with ROBOTUI_RT_IO_PLUGIN(" + type_ +
                      "), or name it under plugins.");
  }
  if (kind == PluginKind::kControl) {
    return make<ControlPlugin>(control, file_);
  }
  return std::make_unique<IoAdapter>(make<IoPlugin>(io, file_));
}

bool PluginLibrary::unload() noexcept {
  if (handle_ == nullptr) {
    return true;
  }
  dlclose(handle_);
  handle_ = nullptr;
  void* left = dlopen(file_.c_str(), RTLD_NOW | RTLD_NOLOAD);
  if (left != nullptr) {
    dlclose(left);
  }
  return left == nullptr;
}

std::vector<fs::path> pluginFolders(const fs::path& config) {
  const fs::path above = executableFolder().parent_path();
  std::vector<fs::path> folders{executableFolder(), above / "lib", above / "lib" / "robotui-rt"};
  const char* named = std::getenv("ROBOTUI_RT_PLUGINS");
  std::istringstream list(named == nullptr ? "" : named);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  folders.push_back(fs::absolute(config).parent_path());
  return folders;
}

}  // namespace robotui::rt::host
