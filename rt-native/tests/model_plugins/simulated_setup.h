// A plugin that leads a robot with forces and contacts, simulated in the same process.
#pragma once

#include <algorithm>

#include "fake_setup.h"
#include "mujoco_hal.h"

namespace robotui::rt::plugins {

class SimulatedRobot {
 public:
  explicit SimulatedRobot(FakeSetup& setup)
      : setup_(setup), references_(setup.robot().description().joints.size()), joints_(references_.size()),
        imus_(setup.robot().description().imus.size()),
        force_torques_(setup.robot().description().force_torques.size()) {
    config::HalConfig config;
    config.type = "mujoco";
    config.params = YAML::Load("{}");
    hal.open(setup.robot().description(), config, 1'000'000);
    sense();
  }

  // Cycles of a millisecond, in each of which the plugin commands what the simulation does.
  void run(ControlPlugin& plugin, int cycles) {
    for (int cycle = 0; cycle < cycles; ++cycle) {
      ASSERT_TRUE(plugin.control_loop(0.001 * cycle, 0.001).isOk());
      for (int i = 0; i < setup_.robot().getJointNum(); ++i) {
        const link::JointCommand& command = setup_.robot().joint(i).command();
        references_[static_cast<std::size_t>(i)] = {command.position,  command.velocity, command.effort,
                                                    command.stiffness, command.damping,  command.mode};
      }
      ASSERT_EQ(hal.move(references_), hal::Status::kOk);
      sense();
    }
  }

  hal::MujocoHal hal;

 private:
  void sense() {
    hal::Measurements into{joints_, imus_, force_torques_};
    hal.sense(into);
    for (int i = 0; i < setup_.robot().getJointNum(); ++i)
      setup_.robot().state(setup_.robot().joint(i).name()) = joints_[static_cast<std::size_t>(i)];
  }

  FakeSetup& setup_;
  std::vector<hal::Reference> references_;
  std::vector<link::JointState> joints_;
  std::vector<link::ImuState> imus_;
  std::vector<link::ForceTorqueState> force_torques_;
};

}  // namespace robotui::rt::plugins
