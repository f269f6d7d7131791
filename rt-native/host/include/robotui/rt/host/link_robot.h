// The robot as a plugin in a host sees it: the state of this cycle, and the commands it gave.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "robotui/rt/link/layout.h"
#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt::host {

class LinkRobot final : public RobotInterface {
 public:
  // Senses from `frame`, until it is to follow another one.
  LinkRobot(std::shared_ptr<const config::RobotDescription> description, const link::FrameData& frame);
  void follow(const link::FrameData& frame) noexcept { frame_ = &frame; }
  const link::FrameData& frame() const noexcept { return *frame_; }

  bool sense() noexcept override;

  // Moves what was set into outgoing(): a joint that is not set again is not commanded again.
  bool move() noexcept override;

  // The commands of the cycle; mode 0 is none.
  std::span<const link::JointCommand> outgoing() const noexcept { return outgoing_; }
  void beginCycle() noexcept;

 private:
  const link::FrameData* frame_;
  std::uint64_t sensed_ = 0;
  std::vector<link::JointCommand> outgoing_;
};

}  // namespace robotui::rt::host
