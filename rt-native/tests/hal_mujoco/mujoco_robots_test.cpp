// Robots that stand, and real ones.
#include <gtest/gtest.h>

#include <cmath>

#include "robotui/rt/link/allocations.h"
#include "simulated.h"

namespace robotui::rt::hal {
namespace {

double feetCarry(const Simulated& robot) {
  double sum = 0;
  for (std::size_t i = 0; i < robot.force_torques.size(); ++i) {
    if (robot.robot->force_torques[i].name.find("ankle") != std::string::npos) sum += robot.force_torques[i].force[2];
  }
  return sum;
}

TEST(Humanoid, StandsOnItsFeetInItsHomePosture) {
  Simulated humanoid(robotNamed("humanoid"));
  ASSERT_EQ(humanoid.run(3000), Status::kOk);
  const auto& q = humanoid.imus.at(0).orientation;
  const double tilt = 2 * std::hypot(q[0], q[1]);
  EXPECT_LT(tilt, 0.1);
  EXPECT_NEAR(humanoid.imus[0].linear_acceleration[2], 9.81, 0.2);
  const double weight = buildRigidTree(*humanoid.robot).mass() * kGravity;
  EXPECT_NEAR(feetCarry(humanoid), weight, 0.1 * weight);
}

TEST(Humanoid, HangsWhereItsBaseIsFixed) {
  Simulated humanoid(robotNamed("humanoid"), "{fix_base: true}");
  ASSERT_EQ(humanoid.run(500), Status::kOk);
  EXPECT_LT(std::abs(feetCarry(humanoid)), 60);
  EXPECT_NEAR(humanoid.joint("left_knee").link_position, 0.7, 5e-3);
}

TEST(Humanoid, StandsWithoutAllocating) {
  Simulated humanoid(robotNamed("humanoid"));
  humanoid.run(20);
  const auto before = link::allocationCount().calls;
  {
    const link::CountAllocations counting;
    humanoid.run(200);
  }
  EXPECT_EQ(link::allocationCount().calls, before);
}

// The legs of the humanoid as a robot has them that is published with meshes.
RobotPtr withMeshes() {
  auto robot = std::make_shared<config::RobotDescription>(*robotNamed("humanoid"));
  const std::size_t link = robot->urdf.find("<collision>");
  const std::size_t shape = robot->urdf.find("<geometry>", link) + std::string("<geometry>").size();
  robot->urdf.replace(shape, robot->urdf.find("</geometry>", shape) - shape,
                      "<mesh filename=\"package://robot/foot.stl\"/>");
  return robot;
}

TEST(Meshes, OfARobotThatStandsAreRefusedWithTheWaysOut) {
  try {
    Simulated robot(withMeshes());
    FAIL() << "it would fall through the floor";
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("no collisions of meshes"), std::string::npos) << said;
    EXPECT_NE(said.find("fix_base: true"), std::string::npos) << said;
    EXPECT_NE(said.find("ignore_meshes: true"), std::string::npos) << said;
  }
}

TEST(Meshes, OfARobotThatHangsAreSaidOnceUnlessThatIsWanted) {
  Simulated hanging(withMeshes(), "{fix_base: true}");
  const auto said = hanging.hal.news();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("touch nothing in this simulation"), std::string::npos) << said[0];
  EXPECT_TRUE(hanging.hal.news().empty());
  Simulated ignored(withMeshes(), "{ignore_meshes: true}");
  EXPECT_TRUE(ignored.hal.news().empty());
}

TEST(RealRobots, TheyRunUnchanged) {
  for (const char* name : {"panda", "coman"}) {
    const RobotPtr robot = robotNamed(name);
    if (!robot) GTEST_SKIP() << "ROBOTUI_SHARED is not set";
    Simulated simulated(robot, "{fix_base: true}");
    ASSERT_EQ(simulated.run(500), Status::kOk) << name;
    for (std::size_t i = 0; i < simulated.joints.size(); ++i) {
      EXPECT_NEAR(simulated.joints[i].link_position, simulated.references[i].position, 0.02) << robot->joints[i].name;
    }
  }
}

}  // namespace
}  // namespace robotui::rt::hal
