// Swings joints about the place where they were: to see that a robot follows.
#pragma once

#include <vector>

#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

// Parameters: `joints` or `chains` (default: all), `amplitude` (rad or m, default 0.1), `frequency` (Hz, default 0.2).
// Kept within the joints' limits of position and velocity. Commands: `amplitude NUMBER`, `frequency NUMBER`; a change
// fades in.
class Sine final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  bool on_command(std::string_view words) override;

 private:
  struct Swing {
    Joint* joint;
    double centre;
    double amplitude;  // what the limits leave of it
  };
  void limit(Swing& swing) const noexcept;

  std::vector<Swing> swings_;
  double amplitude_ = 0.1;
  double frequency_ = 0.2;
  double phase_ = 0;
  double grown_ = 0;  // 0 to 1 in the first seconds
};

}  // namespace robotui::rt::plugins
