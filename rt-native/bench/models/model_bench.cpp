// What one call of each model costs, for robots of ours and, where ROBOTUI_SHARED is set, real ones. CPU time, in
// microseconds.
#include <benchmark/benchmark.h>

#include "robots.h"
#include "robotui/rt/robot/model_interface.h"

namespace robotui::rt {
namespace {

struct Call {
  explicit Call(ModelInterface& of)
      : model(of), tau(Eigen::VectorXd::Zero(of.getDofs())), qddot(Eigen::VectorXd::Ones(of.getDofs())),
        m(of.getDofs(), of.getDofs()), jacobian(6, of.getDofs()),
        tip(of.findLink(of.description().chains.front().tip_link)) {
    model.setJointPosition(Eigen::VectorXd::LinSpaced(model.getJointNum(), -0.5, 0.5));
    model.setJointVelocity(Eigen::VectorXd::LinSpaced(model.getJointNum(), 0.5, -0.5));
    model.update();
  }
  ModelInterface& model;
  Eigen::VectorXd tau;
  Eigen::VectorXd qddot;
  Eigen::MatrixXd m;
  Eigen::MatrixXd jacobian;
  LinkId tip;
  Eigen::Isometry3d pose;
};

using Body = void (*)(Call&);

const std::vector<std::pair<const char*, Body>> kCalls = {
    {"update", [](Call& c) { c.model.update(); }},
    {"pose", [](Call& c) { c.model.getPose(c.tip, c.pose); }},
    {"jacobian", [](Call& c) { c.model.getJacobian(c.tip, c.jacobian); }},
    {"gravity", [](Call& c) { c.model.computeGravityCompensation(c.tau); }},
    {"inverse_dynamics", [](Call& c) { c.model.computeInverseDynamics(c.qddot, c.tau); }},
    {"inertia", [](Call& c) { c.model.getInertiaMatrix(c.m); }},
};

void add(const std::string& robot, const std::string& type) {
  const RobotPtr description = robotNamed(robot);
  if (!description) return;
  const std::shared_ptr<ModelInterface> model = ModelInterface::create(type, description);
  for (const auto& [name, body] : kCalls) {
    const std::string title = robot + "/" + type + "/" + name;
    benchmark::RegisterBenchmark(title.c_str(), [model, call = body](benchmark::State& state) {
      Call at(*model);
      for (auto _ : state) {
        call(at);
        benchmark::ClobberMemory();
      }
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace
}  // namespace robotui::rt

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (const char* robot : {"arm", "panda", "humanoid", "coman"}) {
    for (const auto& type : robotui::rt::ModelInterface::types()) robotui::rt::add(robot, type);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
