// The safe law with the models that the HAL uses, on the demo's robots.
#include <gtest/gtest.h>

#include <cmath>

#include "robotui/rt/link/allocations.h"
#include "robotui/rt/robot/model_interface.h"
#include "safe_torque.h"
#include "silent_plugin.h"

namespace robotui::rt::hal {
namespace {

double angleOf(const config::RobotDescription& robot, const std::string& joint, const std::string& posture) {
  for (const auto& there : robot.postures) {
    if (there.name != posture) continue;
    for (const auto& [name, angle] : there.joints) {
      if (name == joint) return angle;
    }
  }
  throw std::runtime_error("no " + joint + " in " + posture);
}

// A robot with a fixed base that moves as the laws of mechanics say, from its posture `home`.
class MovedByEfforts : public Hal {
 public:
  explicit MovedByEfforts(const RobotPtr& robot)
      : model_(ModelInterface::create("KDL", robot)), q_(model_->getJointNum()) {
    for (int i = 0; i < q_.size(); ++i) q_[i] = angleOf(*robot, model_->joint(i).name(), "home");
    start = q_;
    qdot_ = tau_ = bias_ = Eigen::VectorXd::Zero(q_.size());
    m_.resize(q_.size(), q_.size());
    motors_.resize(q_.size());
    for (int i = 0; i < q_.size(); ++i)
      motors_[i] = 0.001 * model_->joint(i).description().effort;  // as the simulation takes them
  }
  void open(const config::RobotDescription& /*robot*/, const config::HalConfig& /*config*/,
            std::int64_t /*period_ns*/) override {}
  Status sense(Measurements& into) noexcept override {
    for (Eigen::Index i = 0; i < q_.size(); ++i) {
      link::JointState& joint = into.joints[static_cast<std::size_t>(i)];
      joint.link_position = joint.motor_position = q_[i];
      joint.link_velocity = joint.motor_velocity = qdot_[i];
    }
    return Status::kOk;
  }
  Status move(std::span<const Reference> references) noexcept override {
    constexpr int kSteps = 4;
    constexpr double kStep = 0.001 / kSteps;
    for (Eigen::Index i = 0; i < q_.size(); ++i) tau_[i] = references[static_cast<std::size_t>(i)].effort;
    for (int step = 0; step < kSteps; ++step) {
      model_->setJointPosition(q_);
      model_->setJointVelocity(qdot_);
      model_->update();
      model_->getInertiaMatrix(m_);
      m_.diagonal() += motors_;
      model_->computeNonlinearTerm(bias_);
      qdot_ += kStep * m_.ldlt().solve(tau_ - bias_);
      q_ += kStep * qdot_;
    }
    return Status::kOk;
  }
  void close() noexcept override {}

  double moved() const { return (q_ - start).cwiseAbs().maxCoeff(); }

  Eigen::VectorXd start;

 private:
  std::unique_ptr<ModelInterface> model_;
  Eigen::VectorXd q_;
  Eigen::VectorXd qdot_;
  Eigen::VectorXd tau_;
  Eigen::VectorXd bias_;
  Eigen::VectorXd motors_;
  Eigen::MatrixXd m_;
};

class SafeLaw : public testing::TestWithParam<std::string> {
 protected:
  RobotPtr arm_ = robotNamed("arm");
};

TEST_P(SafeLaw, HoldsTheArmWhoseEffortsNobodyCommandsAnyMore) {
  const auto law = makeGravityTorque(arm_, GetParam());
  MovedByEfforts hardware(arm_);
  SilentPlugin robot(arm_, hardware, *law);
  ASSERT_TRUE(robot.isSafe());
  robot.run(1000);
  EXPECT_LT(hardware.moved(), 0.05);
  EXPECT_GT(robot.mostEffort(), 10) << "it carries the arm";
}

TEST_P(SafeLaw, IsTheWeightOfTheModelAndTheOppositeUpsideDown) {
  const RobotPtr humanoid = robotNamed("humanoid");
  const auto law = makeGravityTorque(humanoid, GetParam());
  std::vector<link::JointState> joints(humanoid->joints.size());
  std::vector<link::ImuState> imus(humanoid->imus.size());
  const Measurements measured{joints, imus, {}};
  for (std::size_t i = 0; i < joints.size(); ++i)
    joints[i].link_position = angleOf(*humanoid, humanoid->joints[i].name, "home");
  std::vector<double> upright(joints.size());
  std::vector<double> turned(joints.size());
  imus[0].orientation = {0, 0, 0, 1};
  law->compute(measured, upright);
  imus[0].orientation = {1, 0, 0, 0};
  law->compute(measured, turned);
  double most = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    EXPECT_NEAR(turned[i], -upright[i], 1e-9) << humanoid->joints[i].name;
    most = std::max(most, std::abs(upright[i]));
  }
  EXPECT_GT(most, 2);
  imus[0].orientation = {0, 0, 0, std::nan("")};
  law->compute(measured, turned);
  for (const double effort : turned) EXPECT_TRUE(std::isfinite(effort));
}

// The sensor is not the base: how it is mounted is the model's matter.
TEST_P(SafeLaw, KnowsHowTheImuIsMounted) {
  const RobotPtr plain = robotNamed("humanoid");
  const auto turned = std::make_shared<config::RobotDescription>(*plain);
  const std::string mount = "<origin xyz=\"-0.05 0 0.02\"/><parent link=\"pelvis\"/>";
  const std::size_t at = turned->urdf.find(mount);
  ASSERT_NE(at, std::string::npos);
  turned->urdf.replace(at, mount.size(),
                       "<origin xyz=\"-0.05 0 0.02\" rpy=\"0 1.5707963267948966 0\"/><parent link=\"pelvis\"/>");
  std::vector<link::JointState> joints(plain->joints.size());
  std::vector<link::ImuState> imus(plain->imus.size());
  const Measurements measured{joints, imus, {}};
  std::vector<double> expected(joints.size());
  std::vector<double> found(joints.size());
  imus[0].orientation = {0, 0, 0, 1};
  makeGravityTorque(plain, GetParam())->compute(measured, expected);
  imus[0].orientation = {0, std::sqrt(0.5), 0,
                         std::sqrt(0.5)};  // what a sensor says that is mounted so, on a base that stands
  makeGravityTorque(turned, GetParam())->compute(measured, found);
  for (std::size_t i = 0; i < joints.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << plain->joints[i].name;
}

TEST_P(SafeLaw, AllocatesNothing) {
  const auto law = makeGravityTorque(arm_, GetParam());
  std::vector<link::JointState> joints(arm_->joints.size());
  std::vector<double> efforts(joints.size());
  const Measurements measured{joints, {}, {}};
  law->compute(measured, efforts);
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    for (int i = 0; i < 100; ++i) law->compute(measured, efforts);
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

INSTANTIATE_TEST_SUITE_P(Models, SafeLaw, testing::ValuesIn(ModelInterface::types()),
                         [](const auto& at) { return at.param; });

// What the law is there for: with damping alone the same arm falls.
TEST(Damping, AloneLetsTheArmFall) {
  const RobotPtr arm = robotNamed("arm");
  NoTorque law;
  MovedByEfforts hardware(arm);
  SilentPlugin robot(arm, hardware, law);
  robot.run(1000);
  EXPECT_GT(hardware.moved(), 0.2);
}

}  // namespace
}  // namespace robotui::rt::hal
