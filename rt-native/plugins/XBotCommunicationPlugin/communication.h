// Gives the references of the master framework to the robot.
#pragma once

#include <memory>
#include <vector>

#include "robotui/rt/link/command.h"
#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::plugins {

// Commands all joints, or `joints` and `chains` of its parameters. Masters are slower than the control: positions go
// from one reference to the next in even steps, no faster than the joint may. A joint for which there is no reference,
// or none any more, holds the last one.
class XBotCommunicationPlugin final : public ControlPlugin {
 public:
  PluginRole role() const noexcept override { return PluginRole::kMaster; }
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) noexcept override;
  RtStatus control_loop(double time, double period) noexcept override;
  std::string_view status() const noexcept override { return status_; }

 private:
  struct Held {
    Joint* joint;
    double position;  // what it is told now
    double target;    // the master's reference, to which it goes also when no other follows
    double speed;
  };
  bool readMaster(double time) noexcept;
  void aim(double seconds) noexcept;
  static void approach(Held& held, double period) noexcept;

  std::vector<Held> joints_;
  std::unique_ptr<link::MasterReader> reader_;
  link::MasterData master_{};
  link::MasterData read_{};
  double heard_ = 0;  // when the newest reference came
  std::string_view status_ = "stopped";
};

}  // namespace robotui::rt::plugins
