#include "library.h"

#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace robotui::rt::hal {

namespace {

template <class Function>
Function* symbol(void* library, const char* name, const std::filesystem::path& file) {
  void* const found = ::dlsym(library, name);
  if (found == nullptr) {
    throw std::runtime_error("The library " + file.string() + " is no HAL: it lacks " + name +
                             ". End its source with ROBOTUI_RT_HAL(Class).");
  }
  return reinterpret_cast<Function*>(found);
}

}  // namespace

// Never unloaded: the process ends with its HAL. All that it calls is asked for only after it was checked: a library
// that was built another way lacks some of it, and the reason says more than the name of a symbol.
std::unique_ptr<Hal> loadLibrary(const std::filesystem::path& file) {
  void* const library = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error("The HAL cannot be loaded: " + std::string(::dlerror()) + ".");
  const std::uint32_t abi = symbol<std::uint32_t()>(library, "robotui_rt_hal_abi", file)();
  if (abi != kHalAbi) {
    throw std::runtime_error("The HAL " + file.string() + " was built for interface " + std::to_string(abi) +
                             ", this program has " + std::to_string(kHalAbi) + ": build it again.");
  }
  const auto facts = symbol<const link::AbiFact*()>(library, "robotui_rt_hal_facts", file);
  const std::string difference = link::abiDifference("The HAL " + file.string(), facts(), kHalFacts);
  if (!difference.empty()) throw std::runtime_error(difference);
  if (::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr)
    throw std::runtime_error("The HAL cannot be loaded: " + std::string(::dlerror()) + ".");
  return std::unique_ptr<Hal>(symbol<Hal*()>(library, "robotui_rt_hal_create", file)());
}

}  // namespace robotui::rt::hal
