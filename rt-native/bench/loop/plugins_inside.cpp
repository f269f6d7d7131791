#include "plugins_inside.h"

#include <algorithm>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/histogram.h"

namespace robotui::rt::bench {

void PluginsInside::open(const config::RobotDescription& robot, const config::HalConfig& config,
                         std::int64_t period_ns) {
  period_s_ = static_cast<double>(period_ns) * 1e-9;
  hardware_->open(robot, config, period_ns);
}

hal::Status PluginsInside::sense(hal::Measurements& into) noexcept {
  const hal::Status status = hardware_->sense(into);
  const std::int64_t sensed = link::now();
  ++frame_->cycle;
  frame_->sensed_ns = sensed;
  std::copy(into.joints.begin(), into.joints.end(), frame_->joints.begin());
  std::copy(into.imus.begin(), into.imus.end(), frame_->imus.begin());
  std::copy(into.force_torques.begin(), into.force_torques.end(), frame_->force_torques.begin());
  for (std::size_t j = 0; j < into.joints.size(); ++j) commands_->joints[j].mode = 0;
  for (const auto& plugin : plugins_) {
    if (plugin->cycle(static_cast<double>(sensed) * 1e-9, period_s_)) collect(*plugin);
  }
  commands_->cycle = frame_->cycle;
  commands_->written_ns = link::now();
  slot_.write(*commands_);
  link::record(answers_, commands_->written_ns - sensed);
  return status;
}

void PluginsInside::collect(const host::HostedPlugin& plugin) noexcept {
  const auto outgoing = plugin.outgoing();
  for (std::uint32_t j = 0; j < outgoing.size(); ++j) {
    if (outgoing[j].mode == 0 || board_.owner(j) != plugin.index()) continue;
    commands_->joints[j] = outgoing[j];
    commands_->joints[j].plugin = static_cast<std::uint16_t>(plugin.index());
  }
}

}  // namespace robotui::rt::bench
