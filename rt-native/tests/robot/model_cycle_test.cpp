// Models in a cycle: nothing allocates.
#include <gtest/gtest.h>

#include "random_state.h"
#include "robots.h"
#include "robotui/rt/link/allocations.h"

namespace robotui::rt {
namespace {

struct ModelCycle : testing::TestWithParam<std::string> {};

TEST_P(ModelCycle, NoCallAllocates) {
  const RobotPtr robot = robotNamed("humanoid");
  const auto model = ModelInterface::create(GetParam(), robot);
  const auto other = ModelInterface::create("KDL", robot);
  model->pair(*other);
  RandomState random;
  random.put(*model, *other);
  const LinkId tip = model->findLink(robot->chains.front().tip_link);
  const Eigen::VectorXd qddot = random.vector(model->getDofs(), 1);
  Eigen::VectorXd tau(model->getDofs());
  Eigen::VectorXd q(model->getJointNum());
  Eigen::MatrixXd m(model->getDofs(), model->getDofs());
  Eigen::MatrixXd jacobian(6, model->getDofs());
  Eigen::Isometry3d pose;
  const Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Zero();

  const std::uint64_t before = link::allocationCount().calls;
  link::allocationCount().counting = true;
  for (int i = 0; i < 100; ++i) {
    model->setFloatingBase(Eigen::Isometry3d::Identity(), twist);
    model->syncFrom(*other);
    model->getPose(tip, pose);
    model->getJacobian(tip, jacobian);
    model->getInertiaMatrix(m);
    model->computeGravityCompensation(tau);
    model->computeNonlinearTerm(tau);
    model->computeInverseDynamics(qddot, tau);
    model->getJointPosition(q);
    model->setPositionReference(q);
    model->syncTo(*other);
  }
  link::allocationCount().counting = false;
  EXPECT_EQ(link::allocationCount().calls, before);
  EXPECT_EQ(other->joint(0).command().position, q[0]);
}

INSTANTIATE_TEST_SUITE_P(All, ModelCycle, testing::ValuesIn(ModelInterface::types()),
                         [](const auto& at) { return at.param; });

}  // namespace
}  // namespace robotui::rt
