#include "robotui/rt/host/link_robot.h"

#include <algorithm>

namespace robotui::rt::host {

LinkRobot::LinkRobot(std::shared_ptr<const config::RobotDescription> description, const link::FrameData& frame)
    : RobotInterface(std::move(description)), frame_(&frame), outgoing_(static_cast<std::size_t>(getJointNum())) {}

bool LinkRobot::sense() noexcept {
  if (frame_->cycle == sensed_) {
    return false;
  }
  std::copy_n(frame_->joints.begin(), states().size(), states().begin());
  std::copy_n(frame_->imus.begin(), imuStates().size(), imuStates().begin());
  std::copy_n(frame_->force_torques.begin(), forceTorqueStates().size(), forceTorqueStates().begin());
  sensed_ = frame_->cycle;
  return true;
}

bool LinkRobot::move() noexcept {
  const auto set = commands();
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set[i].mode != 0) {
      outgoing_[i] = set[i];
      set[i].mode = 0;
    }
  }
  return true;
}

void LinkRobot::beginCycle() noexcept {
  for (link::JointCommand& command : outgoing_) {
    command.mode = 0;
  }
}

}  // namespace robotui::rt::host
