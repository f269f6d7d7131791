#include "joint_falls.h"

#include <algorithm>

namespace robotui::rt::hal {

JointFalls::JointFalls(std::uint32_t joints, std::uint64_t say_again_after)
    : say_again_after_(say_again_after), said_(joints) {}

link::JointEvent JointFalls::eventOf(std::uint32_t joint, const JointControl& control) const noexcept {
  link::JointEvent event;
  event.plugin = control.owner();
  event.joint = static_cast<std::uint16_t>(joint);
  event.grant = control.grant();
  event.objection = control.objection();
  event.rejected = control.rejected();
  event.cycle = cycle_;
  event.stops = stops_;
  event.joints.set(joint);
  return event;
}

void JointFalls::refused(std::uint32_t joint, const JointControl& control) noexcept {
  if (said_[joint] != 0 && cycle_ - said_[joint] < say_again_after_) return;
  if (queue_.push(eventOf(joint, control))) said_[joint] = cycle_;
}

// What nobody owns has no plugin that could be told of.
void JointFalls::fell(std::uint32_t joint, const JointControl& control, link::FallCause cause, double error) noexcept {
  if (control.owner() >= link::kMaxPlugins) return;
  if (hasFallen(control.owner())) {
    fellToo(joint, control.owner());
  } else if (count_ < fallen_.size()) {
    link::JointEvent& event = fallen_[count_++];
    event = eventOf(joint, control);
    event.cause = cause;
    event.error = error;
  }
}

bool JointFalls::hasFallen(std::uint16_t plugin) const noexcept {
  return std::any_of(fallen_.begin(), fallen_.begin() + static_cast<std::ptrdiff_t>(count_),
                     [&](const link::JointEvent& event) { return event.plugin == plugin && event.cycle == cycle_; });
}

void JointFalls::fellToo(std::uint32_t joint, std::uint16_t plugin) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (fallen_[i].plugin == plugin && fallen_[i].cycle == cycle_) fallen_[i].joints.set(joint);
  }
}

// What finds no room is told in a cycle after.
void JointFalls::end() noexcept {
  while (count_ > 0 && queue_.push(fallen_[count_ - 1])) --count_;
}

}  // namespace robotui::rt::hal
