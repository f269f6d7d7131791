// Plugins in the HAL's own thread, one behind the other, as the paper has them: for comparison alone, since a plugin
// that crashes or spins then takes the HAL with it.
#pragma once

#include <memory>
#include <vector>

#include "robotui/rt/hal/hal.h"
#include "robotui/rt/host/hosted_plugin.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/command.h"

namespace robotui::rt::bench {

using Plugins = std::vector<std::unique_ptr<host::HostedPlugin>>;

// A hardware that runs the plugins as soon as it has sensed. Their commands lie in the slot before the cycle looks for
// them.
class PluginsInside final : public hal::Hal {
 public:
  PluginsInside(std::unique_ptr<hal::Hal> hardware, const link::BoardSegment& board, link::HostSegment& host,
                std::uint32_t joints)
      : hardware_(std::move(hardware)), board_(board), slot_(host, 0, joints) {}

  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  hal::Status sense(hal::Measurements& into) noexcept override;
  hal::Status move(std::span<const hal::Reference> references) noexcept override { return hardware_->move(references); }
  void close() noexcept override { hardware_->close(); }

  // What they sense; before the first cycle.
  const link::FrameData& frame() const noexcept { return *frame_; }
  void run(Plugins plugins) { plugins_ = std::move(plugins); }

  // From sensing to their commands.
  const link::Histogram& answers() const noexcept { return answers_; }

 private:
  void collect(const host::HostedPlugin& plugin) noexcept;

  std::unique_ptr<hal::Hal> hardware_;
  link::BoardReader board_;
  link::SlotWriter slot_;
  Plugins plugins_;
  double period_s_ = 0;
  std::unique_ptr<link::FrameData> frame_ = std::make_unique<link::FrameData>();
  std::unique_ptr<link::CommandData> commands_ = std::make_unique<link::CommandData>();
  link::Histogram answers_{};
};

}  // namespace robotui::rt::bench
