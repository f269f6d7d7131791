// A plugin that does what each does and nothing more: it looks at all joints and commands its own. What is measured
// with it is the frame around plugins; what their laws cost is theirs.
#include <vector>

#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt::bench {

// Parameter: `joints`, those that it holds where they are; without it looks on.
class BenchPlugin final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override {
    robot_ = &setup.robot();
    positions_.resize(robot_->getJointNum());
    for (const auto& name : setup.params()["joints"]) own_.push_back(robot_->findJoint(name.as<std::string>()));
    return true;
  }

  RtStatus control_loop(double /*time*/, double /*period*/) override {
    robot_->getJointPosition(positions_);
    for (Joint* joint : own_) joint->setPositionReference(positions_[joint->index()]);
    return RtStatus::ok();
  }

 private:
  RobotInterface* robot_ = nullptr;
  Eigen::VectorXd positions_;
  std::vector<Joint*> own_;
};

}  // namespace robotui::rt::bench

using robotui::rt::bench::BenchPlugin;
ROBOTUI_RT_PLUGIN(BenchPlugin)
