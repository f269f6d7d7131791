// A simulated robot in a cycle of its own, as fast as it goes.
#pragma once

#include <vector>

#include "mujoco_hal.h"
#include "robots.h"

namespace robotui::rt::hal {

class Simulated {
 public:
  explicit Simulated(RobotPtr of, const std::string& params = "{}")
      : robot(std::move(of)), references(robot->joints.size()) {
    config::HalConfig config;
    config.type = "mujoco";
    config.params = YAML::Load(params);
    hal.open(*robot, config, 1'000'000);
    joints.resize(robot->joints.size());
    imus.resize(robot->imus.size());
    force_torques.resize(robot->force_torques.size());
    sense();
    for (std::size_t i = 0; i < joints.size(); ++i)
      references[i] = {joints[i].link_position, 0, 0, 0, 0, link::kPosition};
  }

  Status sense() {
    Measurements into{joints, imus, force_torques};
    return hal.sense(into);
  }
  Status run(int cycles) {
    Status status = Status::kOk;
    for (int i = 0; i < cycles && status == Status::kOk; ++i) {
      status = hal.move(references);
      if (status == Status::kOk) status = sense();
    }
    return status;
  }
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < robot->joints.size(); ++i) {
      if (robot->joints[i].name == name) return i;
    }
    throw std::runtime_error("no joint " + name);
  }
  link::JointState& joint(const std::string& name) { return joints[index(name)]; }
  Reference& reference(const std::string& name) { return references[index(name)]; }

  RobotPtr robot;
  MujocoHal hal;
  std::vector<link::JointState> joints;
  std::vector<link::ImuState> imus;
  std::vector<link::ForceTorqueState> force_torques;
  std::vector<Reference> references;
};

}  // namespace robotui::rt::hal
