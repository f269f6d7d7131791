// Two back-ends that share nothing but the bodies say the same.
#include <gtest/gtest.h>

#include "random_state.h"
#include "robots.h"

namespace robotui::rt {
namespace {

struct BackEnds : testing::TestWithParam<std::string> {
  std::unique_ptr<ModelInterface> kdl;
  std::unique_ptr<ModelInterface> mujoco;
  RobotPtr robot;
  RandomState random;
  void SetUp() override {
    robot = robotNamed(GetParam());
    if (!robot) GTEST_SKIP() << "ROBOTUI_SHARED is not set";
    kdl = ModelInterface::create("KDL", robot);
    mujoco = ModelInterface::create("MUJOCO", robot);
  }
  static void near(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9 * (1 + a.cwiseAbs().maxCoeff()));
  }
};

TEST_P(BackEnds, AgreeOnKinematics) {
  Eigen::MatrixXd a(6, kdl->getDofs());
  Eigen::MatrixXd b(6, kdl->getDofs());
  Eigen::Isometry3d pose_a;
  Eigen::Isometry3d pose_b;
  for (int i = 0; i < 20; ++i) {
    random.put(*kdl, *mujoco);
    for (const auto& chain : robot->chains) {
      ASSERT_TRUE(kdl->getPose(kdl->findLink(chain.tip_link), pose_a));
      ASSERT_TRUE(mujoco->getPose(mujoco->findLink(chain.tip_link), pose_b));
      near(pose_a.matrix(), pose_b.matrix());
      kdl->getJacobian(kdl->findLink(chain.tip_link), a);
      mujoco->getJacobian(mujoco->findLink(chain.tip_link), b);
      near(a, b);
    }
  }
}

TEST_P(BackEnds, AgreeOnDynamics) {
  const int n = kdl->getDofs();
  Eigen::MatrixXd ma(n, n);
  Eigen::MatrixXd mb(n, n);
  Eigen::VectorXd a(n);
  Eigen::VectorXd b(n);
  for (int i = 0; i < 20; ++i) {
    random.put(*kdl, *mujoco);
    const Eigen::VectorXd qddot = random.vector(n, 3);
    kdl->getInertiaMatrix(ma);
    mujoco->getInertiaMatrix(mb);
    near(ma, mb);
    kdl->computeGravityCompensation(a);
    mujoco->computeGravityCompensation(b);
    near(a, b);
    kdl->computeNonlinearTerm(a);
    mujoco->computeNonlinearTerm(b);
    near(a, b);
    kdl->computeInverseDynamics(qddot, a);
    mujoco->computeInverseDynamics(qddot, b);
    near(a, b);
  }
}

INSTANTIATE_TEST_SUITE_P(All, BackEnds, testing::Values("arm", "humanoid", "panda", "coman"),
                         [](const auto& at) { return at.param; });

}  // namespace
}  // namespace robotui::rt
