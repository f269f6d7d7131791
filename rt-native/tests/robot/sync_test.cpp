#include <gtest/gtest.h>

#include <algorithm>

#include "robotui/rt/robot/model_interface.h"
#include "robots.h"

namespace robotui::rt {
namespace {

// A model of the left arm alone, whose joints come in another order, too.
struct Sync : testing::Test {
  RobotPtr whole = ownRobot("humanoid", false);
  RobotPtr part = [this] {
    auto less = std::make_shared<config::RobotDescription>(*whole);
    std::erase_if(less->joints, [](const auto& joint) { return !joint.name.starts_with("left_") || joint.id > 20; });
    std::reverse(less->joints.begin(), less->joints.end());
    less->chains.clear();
    return less;
  }();
  std::unique_ptr<ModelInterface> robot = ModelInterface::create("KDL", whole);
  std::unique_ptr<ModelInterface> model = ModelInterface::create("KDL", part);
  void SetUp() override {
    ASSERT_EQ(model->getJointNum(), 7);
    robot->setJointPosition(Eigen::VectorXd::LinSpaced(robot->getJointNum(), 0.1, 0.9));
    robot->setJointVelocity(Eigen::VectorXd::LinSpaced(robot->getJointNum(), -0.5, 0.5));
    robot->setJointEffort(Eigen::VectorXd::LinSpaced(robot->getJointNum(), 3, 4));
  }
  void expectSame() {
    for (int i = 0; i < model->getJointNum(); ++i) {
      const Joint* there = robot->findJoint(model->joint(i).name());
      EXPECT_EQ(model->joint(i).getJointPosition(), there->getJointPosition());
      EXPECT_EQ(model->joint(i).getJointVelocity(), there->getJointVelocity());
      EXPECT_EQ(model->joint(i).getJointEffort(), there->getJointEffort());
    }
  }
};

TEST_F(Sync, AModelWithFewerJointsTakesThoseThatBothHave) {
  model->syncFrom(*robot);
  expectSame();
}

TEST_F(Sync, ThePairsAreTheSameAsTheSearch) {
  model->pair(*robot);
  model->syncFrom(*robot);
  expectSame();
}

TEST_F(Sync, OnlyReferencesThatAreSetGoBack) {
  model->joint(2).setPositionReference(0.75);
  model->syncTo(*robot);
  int set = 0;
  for (int i = 0; i < robot->getJointNum(); ++i) set += robot->joint(i).command().mode != 0 ? 1 : 0;
  EXPECT_EQ(set, 1);
  const Joint* there = robot->findJoint(model->joint(2).name());
  EXPECT_EQ(there->command().position, 0.75);
  EXPECT_EQ(there->command().mode, link::kPosition);
}

}  // namespace
}  // namespace robotui::rt
