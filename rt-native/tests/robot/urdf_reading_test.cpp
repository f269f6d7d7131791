// Our bodies are those that MuJoCo's own reader of URDF finds: nothing of ours is between.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>

#include "robotui/rt/robot/model_interface.h"
#include "robots.h"

namespace robotui::rt {
namespace {

struct UrdfReading : testing::TestWithParam<std::string> {};

TEST_P(UrdfReading, IsThatOfMujoco) {
  const std::string file = std::string(RT_CONFIGS) + "/" + GetParam() + "/" + GetParam() + ".urdf";
  std::array<char, 500> error{};
  mjModel* theirs = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  ASSERT_NE(theirs, nullptr) << error.data();
  mjData* data = mj_makeData(theirs);
  const auto model = ModelInterface::create("KDL", ownRobot(GetParam(), false));
  ASSERT_EQ(theirs->nv, model->getDofs());
  Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(model->getDofs(), -0.7, 0.8);
  for (int i = 0; i < model->getDofs(); ++i) {
    const int id = mj_name2id(theirs, mjOBJ_JOINT, model->joint(i).name().c_str());
    ASSERT_GE(id, 0) << model->joint(i).name();
    data->qpos[theirs->jnt_qposadr[id]] = q[i];
    data->qvel[theirs->jnt_dofadr[id]] = 0.5 - q[i];
  }
  mj_forward(theirs, data);
  model->setJointPosition(q);
  model->setJointVelocity(Eigen::VectorXd::Constant(q.size(), 0.5) - q);
  model->update();
  Eigen::VectorXd bias(model->getDofs());
  model->computeNonlinearTerm(bias);
  for (int i = 0; i < model->getDofs(); ++i) {
    const int id = mj_name2id(theirs, mjOBJ_JOINT, model->joint(i).name().c_str());
    EXPECT_NEAR(data->qfrc_bias[theirs->jnt_dofadr[id]], bias[i], 1e-8) << model->joint(i).name();
  }
  mj_deleteData(data);
  mj_deleteModel(theirs);
}

INSTANTIATE_TEST_SUITE_P(Both, UrdfReading, testing::Values("arm", "humanoid"),
                         [](const auto& at) { return at.param; });

}  // namespace
}  // namespace robotui::rt
