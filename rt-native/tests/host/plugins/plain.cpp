// A plugin that does nothing: built in several ways, of which only one fits the host.
#include "robotui/rt/plugin/control_plugin.h"

namespace {

class Plain final : public robotui::rt::ControlPlugin {
 public:
  bool init_control_plugin(robotui::rt::Setup& setup) override {
    return setup.params()["works"].as<std::string>("yes") == "yes";
  }
  robotui::rt::RtStatus control_loop(double /*time*/, double /*period*/) override {
    return robotui::rt::RtStatus::ok();
  }
};

}  // namespace

ROBOTUI_RT_PLUGIN(Plain)
