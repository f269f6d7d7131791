// What a plugin is there for, as it declares it: by this, not by its name, the supervisor knows which plugins may run
// beside which.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace robotui::rt::link {

enum class PluginRole : std::uint8_t {
  kControl,   // commands the joints that it claims: beside others, as long as those claim other joints
  kMaster,    // passes on the references of the master framework: not beside plugins that control
  kObserver,  // commands no joint: beside all others
};

inline constexpr std::array<std::string_view, 3> kPluginRoles{"control", "master",
                                                              "observer"};  // as words of the protocol

constexpr std::string_view nameOf(PluginRole role) noexcept { return kPluginRoles[static_cast<std::size_t>(role)]; }

constexpr std::optional<PluginRole> pluginRole(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kPluginRoles.size(); ++i) {
    if (kPluginRoles[i] == name) return static_cast<PluginRole>(i);
  }
  return std::nullopt;
}

}  // namespace robotui::rt::link
