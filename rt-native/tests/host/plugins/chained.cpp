// Two that feed one another: one writes its time into a channel in each loop, the other one reads it and fails where
// nothing was written in the same cycle.
#include "robotui/rt/plugin/control_plugin.h"

namespace {

using namespace robotui::rt;

class Chained final : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override {
    const auto channel = setup.params()["channel"].as<std::string>();
    feeds_ = setup.params()["feeds"].as<bool>();
    if (feeds_)
      writer_ = ChannelWriter<double>(setup.channels(), channel);
    else
      reader_ = ChannelReader<double>(setup.channels(), channel);
    for (const auto& name : setup.params()["joints"]) joint_ = setup.robot().findJoint(name.as<std::string>());
    return true;
  }
  RtStatus on_start(double /*time*/) override {
    held_ = joint_ == nullptr ? 0 : joint_->getJointPosition();
    return RtStatus::ok();
  }
  RtStatus control_loop(double time, double /*period*/) override {
    if (joint_ != nullptr) joint_->setPositionReference(held_);
    double fed = 0;
    if (feeds_)
      writer_.write(time);
    else if (!reader_.latest(fed) || fed != time)
      return RtStatus::failed("nobody feeds it in this cycle");
    return RtStatus::ok();
  }

 private:
  bool feeds_ = false;
  Joint* joint_ = nullptr;
  double held_ = 0;
  ChannelWriter<double> writer_;
  ChannelReader<double> reader_;
};

}  // namespace

ROBOTUI_RT_PLUGIN(Chained)
