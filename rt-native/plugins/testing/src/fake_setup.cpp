#include "robotui/rt/testing/fake_setup.h"

#include "robotui/rt/link/allocations.h"

namespace robotui::rt::testing {

FakeSetup::FakeSetup(FakeRobot& robot, const std::string& params, double period, std::string model_type)
    : params_(params.empty() ? YAML::Node(YAML::NodeType::Map) : YAML::Load(params)), period_(period),
      model_type_(std::move(model_type)), robot_(robot), segment_(std::make_unique<ChannelSegment>()),
      channels_(*segment_, {segment_.get()}), master_(std::make_unique<link::MasterSegment>()) {
  robot.setPeriod(period);
}

std::unique_ptr<ModelInterface> FakeSetup::createModel() {
  return ModelInterface::create(model_type_, std::make_shared<const config::RobotDescription>(robot_.description()));
}

void PluginBench::cycles(int count) {
  const std::uint64_t before = link::allocationCount().calls;
  for (int i = 0; i < count; ++i) {
    const link::CountAllocations counting;
    setup_.fake().sense();
    note(plugin_.control_loop(time_, setup_.period()));
    setup_.fake().move();
    time_ += setup_.period();
  }
  allocations_ += link::allocationCount().calls - before;
}

}  // namespace robotui::rt::testing
