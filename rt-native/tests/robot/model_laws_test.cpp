// What holds for every model of a robot, whoever computes it.
#include <gtest/gtest.h>

#include "random_state.h"
#include "robots.h"

namespace robotui::rt {
namespace {

using Case = std::tuple<std::string, std::string>;

struct ModelLaws : testing::TestWithParam<Case> {
  std::unique_ptr<ModelInterface> model;
  RandomState random;
  std::string tip;
  void SetUp() override {
    const auto& [type, name] = GetParam();
    const RobotPtr robot = robotNamed(name);
    if (!robot) GTEST_SKIP() << "ROBOTUI_SHARED is not set";
    model = ModelInterface::create(type, robot);
    tip = robot->chains.front().tip_link;
  }
  Eigen::VectorXd dynamics(const Eigen::VectorXd& qddot) const {
    Eigen::VectorXd tau(model->getDofs());
    model->computeInverseDynamics(qddot, tau);
    return tau;
  }
};

TEST_P(ModelLaws, TheInertiaMatrixIsSymmetricAndPositive) {
  Eigen::MatrixXd m(model->getDofs(), model->getDofs());
  for (int i = 0; i < 10; ++i) {
    random.put(*model);
    model->getInertiaMatrix(m);
    EXPECT_LT((m - m.transpose()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues().minCoeff(), 0);
  }
}

TEST_P(ModelLaws, InverseDynamicsIsInertiaTimesAccelerationPlusBias) {
  Eigen::MatrixXd m(model->getDofs(), model->getDofs());
  Eigen::VectorXd bias(model->getDofs());
  for (int i = 0; i < 10; ++i) {
    random.put(*model);
    const Eigen::VectorXd qddot = random.vector(model->getDofs(), 3);
    model->getInertiaMatrix(m);
    model->computeNonlinearTerm(bias);
    const Eigen::VectorXd tau = dynamics(qddot);
    EXPECT_LT((tau - m * qddot - bias).cwiseAbs().maxCoeff(), 1e-7 * (1 + tau.cwiseAbs().maxCoeff()));
  }
}

TEST_P(ModelLaws, TheJacobianIsTheDerivativeOfThePose) {
  constexpr double kStep = 1e-6;
  const LinkId link = model->findLink(tip);
  Eigen::MatrixXd jacobian(6, model->getDofs());
  Eigen::Isometry3d before;
  Eigen::Isometry3d after;
  random.put(*model);
  ASSERT_TRUE(model->getPose(link, before));
  ASSERT_TRUE(model->getJacobian(link, jacobian));
  const int offset = model->isFloatingBase() ? 6 : 0;
  Eigen::VectorXd q(model->getJointNum());
  model->getJointPosition(q);
  for (int i = 0; i < model->getJointNum(); ++i) {
    Eigen::VectorXd moved = q;
    moved[i] += kStep;
    model->setJointPosition(moved);
    model->update();
    model->getPose(link, after);
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(after.linear() * before.linear().transpose()));
    EXPECT_LT(((after.translation() - before.translation()) / kStep - jacobian.block<3, 1>(0, offset + i)).norm(),
              1e-4);
    EXPECT_LT((turn.axis() * turn.angle() / kStep - jacobian.block<3, 1>(3, offset + i)).norm(), 1e-4);
  }
}

TEST_P(ModelLaws, EnergyIsOnlyChangedByEfforts) {
  // Power of the bias at rest of gravity, q' (tau - g), is the derivative of the kinetic energy 1/2 q' M q' along the
  // motion.
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd m(model->getDofs(), model->getDofs());
  Eigen::VectorXd gravity(model->getDofs());
  random.put(*model);
  model->setFloatingBase(Eigen::Isometry3d::Identity(), Eigen::Matrix<double, 6, 1>::Zero());
  model->update();
  Eigen::VectorXd q(model->getJointNum());
  Eigen::VectorXd qdot(model->getJointNum());
  model->getJointPosition(q);
  model->getJointVelocity(qdot);
  const auto energy = [&](double time) {
    model->setJointPosition(q + time * qdot);
    model->update();
    model->getInertiaMatrix(m);
    return 0.5 * qdot.dot(m.bottomRightCorner(qdot.size(), qdot.size()) * qdot);
  };
  const double slope = (energy(kStep) - energy(-kStep)) / (2 * kStep);
  energy(0);
  model->computeGravityCompensation(gravity);
  const Eigen::VectorXd tau = dynamics(Eigen::VectorXd::Zero(model->getDofs()));
  EXPECT_NEAR(qdot.dot((tau - gravity).tail(qdot.size())), slope, 1e-4 * (1 + std::abs(slope)));
}

TEST_P(ModelLaws, AFloatingBaseCarriesTheWeight) {
  if (!model->isFloatingBase()) {
    EXPECT_EQ(model->getDofs(), model->getJointNum());
    return;
  }
  random.put(*model);
  Eigen::VectorXd gravity(model->getDofs());
  Eigen::MatrixXd m(model->getDofs(), model->getDofs());
  model->computeGravityCompensation(gravity);
  model->getInertiaMatrix(m);
  EXPECT_NEAR(gravity[0], 0, 1e-7);
  EXPECT_NEAR(gravity[2], m(2, 2) * 9.81, 1e-6);
}

TEST_P(ModelLaws, UnknownLinksAndWrongSizesAreRefused) {
  Eigen::Isometry3d pose;
  Eigen::MatrixXd narrow(6, 1);
  EXPECT_FALSE(model->findLink("nobody").isValid());
  EXPECT_FALSE(model->getPose(LinkId{}, pose));
  EXPECT_FALSE(model->getPose(LinkId{100000}, pose));
  EXPECT_FALSE(model->getJacobian(model->findLink(tip), narrow));
}

INSTANTIATE_TEST_SUITE_P(All, ModelLaws,
                         testing::Combine(testing::ValuesIn(ModelInterface::types()),
                                          testing::Values("arm", "humanoid", "panda", "coman")),
                         [](const auto& at) { return std::get<0>(at.param) + "_" + std::get<1>(at.param); });

TEST(ModelInterface, SaysWhichTypesThereAre) {
  try {
    ModelInterface::create("MAGIC", robotNamed("arm"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("'MAGIC'; there are KDL"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace robotui::rt
