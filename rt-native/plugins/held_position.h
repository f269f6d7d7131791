// Where a joint is held: from there a plugin goes on when it starts, and the joint does not jump, even where it does
// not quite follow.
#pragma once

#include <cmath>

#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt::plugins {

// Its reference where it is led by a position, else where it is.
inline double heldPosition(const Joint& joint) noexcept {
  const double reference = joint.getPositionReference();
  const bool is_held = (joint.state().mode & link::kPosition) != 0 && std::isfinite(reference);
  return is_held ? reference : joint.getJointPosition();
}

}  // namespace robotui::rt::plugins
