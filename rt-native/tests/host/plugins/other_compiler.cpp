// What a plugin of a compiler yet to come would say of itself.
#include "robotui/rt/plugin/abi.h"

namespace {

constexpr robotui::rt::link::AbiFact kFacts[] = {{"compiler", "GCC ", 99, "", ""}, {}};

}  // namespace

extern "C" __attribute__((visibility("default"))) std::uint32_t robotui_rt_plugin_abi() {
  return robotui::rt::kPluginAbi;
}
extern "C" __attribute__((visibility("default"))) const robotui::rt::link::AbiFact* robotui_rt_plugin_facts() {
  return kFacts;
}
