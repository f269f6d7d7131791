#include "cartesian_tasks.h"

#include "fake_setup.h"

namespace robotui::rt::plugins {
namespace {

using Eigen::Vector3d;

struct Bench {
  Bench(const RobotPtr& robot, const std::string& params, const std::vector<std::pair<std::string, double>>& from = {})
      : setup(withAcceleration(robot), params) {
    for (const auto& [joint, position] : from) setup.robot().state(joint).link_position = position;
    if (!plugin.init_control_plugin(setup)) throw std::runtime_error(setup.failure);
    model = setup.createModel();
    EXPECT_TRUE(plugin.on_start(0).isOk());
  }

  Eigen::Isometry3d pose(const std::string& link, const std::string& base) {
    Eigen::Isometry3d of_link;
    Eigen::Isometry3d of_base;
    model->syncFrom(setup.robot());
    model->getPose(model->findLink(link), of_link);
    model->getPose(model->findLink(base), of_base);
    return of_base.inverse() * of_link;
  }
  Vector3d place(const std::string& link, const std::string& base) { return pose(link, base).translation(); }
  void cycles(int count) { run(plugin, setup, count); }
  // Cycles in which every joint stays within its limits of position, velocity and acceleration.
  void watchedCycles(int count);
  bool say(const std::string& words) { return plugin.on_command(words); }
  std::string status() const { return std::string(plugin.status()); }
  TaskReport report() {
    TaskReport newest{};
    EXPECT_TRUE((ChannelReader<TaskReport>(setup.channels(), taskChannel("plugin")).latest(newest)));
    return newest;
  }

  FakeSetup setup;
  CartesianTasks plugin;
  std::unique_ptr<ModelInterface> model;
  std::vector<double> velocity;  // of the joints, at the end of the cycles that were watched
};

void Bench::watchedCycles(int count) {
  const auto joints = static_cast<std::size_t>(setup.robot().getJointNum());
  std::vector<double> position(joints);
  velocity.resize(joints);
  for (std::size_t i = 0; i < joints; ++i) position[i] = setup.robot().joint(static_cast<int>(i)).getJointPosition();
  for (int cycle = 0; cycle < count; ++cycle) {
    ASSERT_TRUE(plugin.control_loop(0, 0.001).isOk());
    setup.robot().follow();
    for (std::size_t i = 0; i < joints; ++i) {
      const Joint& joint = setup.robot().joint(static_cast<int>(i));
      const auto& limits = joint.description();
      const double now = joint.getJointPosition();
      const double rate = (now - position[i]) / 0.001;
      ASSERT_TRUE(std::isfinite(now) && now <= limits.upper && now >= limits.lower) << joint.name();
      ASSERT_LE(std::abs(rate), limits.velocity + 1e-6) << joint.name();
      ASSERT_LE(std::abs(rate - velocity[i]), limits.acceleration * 0.001 + 1e-6) << joint.name() << " in " << cycle;
      position[i] = now;
      velocity[i] = rate;
    }
  }
}

const std::string kBothArms = R"(
chains: [left_arm, right_arm]
linear_speed: 0.3
tasks:
  left: {chain: left_arm}
  right: {chain: right_arm}
)";

// Both chains of a robot at once, each 5 cm along.
void expectBothArmsMove(const RobotPtr& robot, const std::string& base, const std::string& left,
                        const std::string& right) {
  Bench bench(robot, kBothArms);
  EXPECT_EQ(bench.setup.claimed.size(), 14U);
  const Vector3d left_before = bench.place(left, base);
  const Vector3d right_before = bench.place(right, base);
  bench.cycles(50);
  EXPECT_EQ(bench.status(), "all tasks are at their targets");
  EXPECT_LT((bench.place(left, base) - left_before).norm(), 1e-6);
  ASSERT_TRUE(bench.say("move left 0.05 0 0.05"));
  ASSERT_TRUE(bench.say("move right 0 -0.04 0.03"));
  bench.watchedCycles(2500);
  EXPECT_LT((bench.place(left, base) - left_before - Vector3d(0.05, 0, 0.05)).norm(), 2e-3) << bench.status();
  EXPECT_LT((bench.place(right, base) - right_before - Vector3d(0, -0.04, 0.03)).norm(), 2e-3) << bench.status();
  EXPECT_EQ(bench.status(), "all tasks are at their targets");
}

TEST(CartesianTasksTest, MovesBothArmsAtOnce) {
  expectBothArmsMove(robotNamed("humanoid"), "chest", "left_hand", "right_hand");
}

TEST(CartesianTasksTest, MovesBothArmsOfAPublishedRobot) {
  const RobotPtr coman = robotNamed("coman");
  if (!coman) GTEST_SKIP() << "ROBOTUI_SHARED is not set";
  expectBothArmsMove(coman, "DWYTorso", "l_wrist", "r_wrist");
}

// How far the left hand leaves the straight line, with the elbow bent that much before.
double mostBesideTheLine(double bent) {
  Bench bench(robotNamed("humanoid"), kBothArms, {{"left_elbow", -bent}});
  const Vector3d before = bench.place("left_hand", "chest");
  const Vector3d way(0.12, 0.05, 0.15);
  EXPECT_TRUE(bench.say("move left 0.12 0.05 0.15"));
  Vector3d last = before;
  double most = 0;
  for (int i = 0; i < 150; ++i) {
    bench.watchedCycles(10);
    const Vector3d now = bench.place("left_hand", "chest");
    EXPECT_LT((now - last).norm(), 0.3 * 0.01 * 1.01);
    most = std::max(most, (now - before).cross(way.normalized()).norm());
    last = now;
  }
  EXPECT_LT((last - before - way).norm(), 2e-3) << bench.status();
  return most;
}

// The path speeds up and slows down more gently than the joints can, so that nothing lags behind it.
TEST(CartesianTasksTest, GoesStraightWithLimitedSpeed) { EXPECT_LT(mostBesideTheLine(0.9), 1e-4); }

TEST(CartesianTasksTest, AStraightArmThatCannotGoOnSaysSo) {
  Bench bench(robotNamed("humanoid"), kBothArms,
              {{"left_shoulder_pitch", 0}, {"left_shoulder_roll", 0}, {"left_elbow", 0}});
  const std::vector<const char*> all{"move left 0 0 0.1", "move left 0.6 0 0", "move left 0 0 -0.2",
                                     "move left 0.3 0 0"};
  for (std::size_t i = 0; i < all.size() / std::size_t{kLess}; ++i) {
    ASSERT_TRUE(bench.say(all[i]));
    bench.watchedCycles(4500);
    for (int cycle = 0; cycle < 200; ++cycle) {  // it says so and does not say otherwise in between
      bench.watchedCycles(1);
      ASSERT_TRUE(bench.status().starts_with("left cannot go on, 0.")) << bench.status();
      ASSERT_NE(bench.status().find(" rad from its target: "), std::string::npos) << bench.status();
    }
    ASSERT_TRUE(bench.say("stop"));
    bench.watchedCycles(500);
    EXPECT_EQ(bench.status(), "all tasks are at their targets");
  }
}

TEST(CartesianTasksTest, ALowerTaskDoesNotDisturbAHigherOneAndSaysSo) {
  Bench bench(robotNamed("humanoid"), R"(
chains: [left_arm]
tasks:
  hand: {chain: left_arm, mask: position}
  elbow: {link: left_elbow_link, base: chest, mask: position, priority: 2}
)");
  const Vector3d hand = bench.place("left_hand", "chest");
  const Vector3d elbow = bench.place("left_elbow_link", "chest");
  ASSERT_TRUE(bench.say("move elbow 0 0.3 0.1"));
  for (int i = 0; i < 20; ++i) {
    bench.watchedCycles(150);
    EXPECT_LT((bench.place("left_hand", "chest") - hand).norm(), 1e-4) << i;
  }
  EXPECT_GT((bench.place("left_elbow_link", "chest") - elbow).norm(), 0.02) << "it does what it can";
  EXPECT_TRUE(bench.status().starts_with("elbow cannot go on, ")) << bench.status();
}

TEST(CartesianTasksTest, AFrameMayBeSeenFromTheOtherHand) {
  Bench bench(robotNamed("humanoid"), R"(
chains: [left_arm, right_arm, torso]
tasks:
  hold: {link: left_hand, base: right_hand}
  right: {link: right_hand, base: pelvis, mask: [x, y, z], priority: 2}
)");
  const Eigen::Isometry3d between = bench.pose("left_hand", "right_hand");
  const Vector3d right = bench.place("right_hand", "pelvis");
  ASSERT_TRUE(bench.say("move right 0.06 0.02 0.04"));
  for (int i = 0; i < 15; ++i) {
    bench.watchedCycles(150);
    const Eigen::Isometry3d now = bench.pose("left_hand", "right_hand");
    EXPECT_LT((now.matrix() - between.matrix()).cwiseAbs().maxCoeff(), 1e-3) << i;
  }
  EXPECT_LT((bench.place("right_hand", "pelvis") - right - Vector3d(0.06, 0.02, 0.04)).norm(), 2e-3) << bench.status();
}

TEST(CartesianTasksTest, AVelocityEndsByItselfUnlessItIsSaidAgain) {
  Bench bench(robotNamed("humanoid"), kBothArms);
  const Vector3d before = bench.place("left_hand", "chest");
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(bench.say("velocity left 0 0 0.1"));
    bench.watchedCycles(100);
    EXPECT_EQ(bench.status(), "moving with a velocity");
  }
  EXPECT_NEAR((bench.place("left_hand", "chest") - before).z(), 0.1, 0.02);
  bench.watchedCycles(900);
  const Vector3d rest = bench.place("left_hand", "chest");
  EXPECT_NEAR((rest - before).z(), 0.12, 0.02);
  bench.watchedCycles(300);
  EXPECT_LT((bench.place("left_hand", "chest") - rest).norm(), 1e-4);
  EXPECT_EQ(bench.status(), "all tasks are at their targets");
}

TEST(CartesianTasksTest, OutOfReachItStaysWithinLimitsAndSaysWhatIsInTheWay) {
  for (const char* words : {"pose left 3 0 -2", "pose left -2 3 1 0 0 3"}) {
    Bench bench(robotNamed("humanoid"), kBothArms);
    ASSERT_TRUE(bench.say(words));
    bench.watchedCycles(6000);
    EXPECT_TRUE(bench.status().starts_with("left cannot go on, ")) << bench.status();
    EXPECT_NE(bench.status().find(" m and "), std::string::npos) << bench.status();
    ASSERT_TRUE(bench.say("stop"));
    bench.watchedCycles(1000);
    EXPECT_EQ(bench.status(), "all tasks are at their targets");
  }
}

TEST(CartesianTasksTest, TheFreedomThatIsLeftGoesToThePosture) {
  Bench bench(robotNamed("humanoid"), R"(
chains: [left_arm]
tasks: {hand: {chain: left_arm, mask: position}}
posture_speed: 1
)");
  const Vector3d hand = bench.place("left_hand", "chest");
  const double yaw = bench.setup.robot().findJoint("left_shoulder_yaw")->getJointPosition();
  ASSERT_TRUE(bench.say("posture arms_forward"));
  bench.watchedCycles(3000);
  EXPECT_LT((bench.place("left_hand", "chest") - hand).norm(), 1e-3);
  ASSERT_TRUE(bench.say("disable hand"));
  bench.watchedCycles(6000);
  EXPECT_NEAR(bench.setup.robot().findJoint("left_shoulder_pitch")->getJointPosition(), -1.2, 1e-2);
  EXPECT_NEAR(yaw, 0, 1e-9);
}

TEST(CartesianTasksTest, SaysWhatItsTasksAreAndHowFarTheyAre) {
  Bench bench(robotNamed("humanoid"), kBothArms);
  const TaskReport before = bench.report();
  ASSERT_EQ(before.count, 2U);
  EXPECT_EQ(view(before.tasks[1].name), "right");
  EXPECT_EQ(view(before.tasks[1].link), "right_hand");
  EXPECT_EQ(view(before.tasks[1].base), "chest");
  EXPECT_EQ(before.tasks[1].mask, 0b111111U);
  EXPECT_DOUBLE_EQ(before.tasks[1].linear, 0.3);
  EXPECT_TRUE(hasJoint(before, static_cast<std::uint32_t>(bench.setup.robot().findJoint("left_elbow")->index())));
  EXPECT_FALSE(hasJoint(before, static_cast<std::uint32_t>(bench.setup.robot().findJoint("left_hip_yaw")->index())));
  ASSERT_TRUE(bench.say("move left 0 0 3"));
  ASSERT_TRUE(bench.say("disable right"));
  bench.watchedCycles(10);
  EXPECT_EQ(bench.report().tasks[0].phase, TaskPhase::kMoving);
  EXPECT_EQ(bench.report().tasks[1].phase, TaskPhase::kDisabled);
  bench.watchedCycles(6000);
  EXPECT_EQ(bench.report().tasks[0].phase, TaskPhase::kStuck) << bench.status();
}

TEST(CartesianTasksTest, RefusesWordsThatAreNone) {
  Bench bench(robotNamed("humanoid"), kBothArms);
  for (const char* words : {"", "pose", "pose left", "pose left 1 2", "pose tail 1 2 3", "move left a b c", "jump left",
                            "pose left 1 2 1e9", "velocity left nan 0 0", "posture lying", "enable", "stop tail"}) {
    EXPECT_FALSE(bench.say(words)) << words;
  }
  ASSERT_TRUE(bench.say("disable left"));
  EXPECT_FALSE(bench.say("pose left 1 2 3")) << "it is disabled";
}

TEST(CartesianTasksTest, WrongParametersAreNamed) {
  for (const char* params :
       {"{}", "{tasks: {}}", "{tasks: {a: {}}}", "{tasks: {a: {chain: tail}}}",
        "{tasks: {a: {chain: left_arm, mask: []}}}", "{tasks: {a: {chain: left_arm, mask: [up]}}}",
        "{tasks: {a: {chain: left_arm, priority: 0}}}", "{tasks: {a: {chain: left_arm}}, posture: lying}",
        "{tasks: {a: {chain: left_arm}}, sped: 1}"}) {
    FakeSetup setup(robotNamed("humanoid"), params);
    CartesianTasks plugin;
    EXPECT_THROW(plugin.init_control_plugin(setup), config::ConfigError) << params;
  }
}

TEST(CartesianTasksTest, ALinkThatIsNotThereIsNamed) {
  FakeSetup setup(robotNamed("humanoid"), "{tasks: {a: {link: tail}}}");
  CartesianTasks plugin;
  EXPECT_THROW(plugin.init_control_plugin(setup), std::runtime_error);
}

}  // namespace
}  // namespace robotui::rt::plugins
