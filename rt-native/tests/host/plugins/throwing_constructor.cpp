#include <stdexcept>

#include "robotui/rt/plugin/control_plugin.h"

namespace {

class ThrowingConstructor final : public robotui::rt::ControlPlugin {
 public:
  ThrowingConstructor() { throw std::runtime_error("no hardware key"); }
  bool init_control_plugin(robotui::rt::Setup& /*setup*/) override { return true; }
  robotui::rt::RtStatus control_loop(double /*time*/, double /*period*/) override {
    return robotui::rt::RtStatus::ok();
  }
};

}  // namespace

ROBOTUI_RT_PLUGIN(ThrowingConstructor)
