#include "part_distances.h"

#include <random>

#include "cartesian_tasks.h"
#include "fake_setup.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kPeriod = 0.004;  // of a slow thread
constexpr int kCycles = 600;
#ifdef NDEBUG
constexpr int kTargets = 60;
#else
constexpr int kTargets = 6;  // with sanitizers a cycle takes a hundred times as long
#endif

using Eigen::Vector3d;
using Kind = CollisionShape::Kind;

std::vector<int> jointsOf(const config::RobotDescription& robot) {
  std::vector<int> all;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) all.push_back(static_cast<int>(i));
  return all;
}

double distanceToCapsule(const Vector3d& point, const Capsule& capsule) {
  const Vector3d along = capsule.to - capsule.from;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - capsule.from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - capsule.from - part * along).norm() - capsule.radius;
}

TEST(PartDistancesTest, ACapsuleContainsItsShape) {
  std::mt19937 random(5);
  const auto one = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  const Eigen::Isometry3d at = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3);
  for (const CollisionShape& shape : {CollisionShape{Kind::kBox, 0, at, "a", {0.1, 0.3, 0.05}},
                                      CollisionShape{Kind::kSphere, 0, at, "a", {0.2, 0, 0}},
                                      CollisionShape{Kind::kCylinder, 0, at, "a", {0.1, 0.4, 0}},
                                      CollisionShape{Kind::kCylinder, 0, at, "a", {0.3, 0.05, 0}}}) {
    const Capsule capsule = capsuleAround(shape);
    for (int i = 0; i < 1000; ++i) {
      Vector3d point(one(), one(), one());
      if (shape.kind == Kind::kBox) point = point.cwiseProduct(shape.size);
      if (shape.kind == Kind::kSphere) point = point.normalized() * shape.size.x();
      if (shape.kind == Kind::kCylinder) {
        point.head<2>() = point.head<2>().normalized() * shape.size.x();
        point.z() *= shape.size.y();
      }
      ASSERT_LE(distanceToCapsule(at * point, capsule), 1e-9);
    }
  }
}

// The rows are the derivatives of the distances, whatever the joints.
TEST(PartDistancesTest, RowsAreHowDistancesChange) {
  const RobotPtr robot = robotNamed("humanoid");
  PartDistances distances(*robot, {0.02, 0.3, {}, {}}, jointsOf(*robot));
  EXPECT_GT(distances.size(), 20U);
  EXPECT_LE(distances.size(), PartDistances::kMostPairs);
  const auto joints = static_cast<Eigen::Index>(robot->joints.size());
  VelocityRows rows(PartDistances::kMostRows, joints);
  std::mt19937 random(3);
  for (int posture = 0; posture < 20; ++posture) {
    Eigen::VectorXd at(joints);
    for (auto& position : at) position = std::uniform_real_distribution<double>(-0.6, 0.6)(random);
    distances.update(at);
    distances.put(rows);
    const Eigen::MatrixXd slopes = rows.rows.topRows(rows.count);
    std::vector<const PartDistances::Pair*> pairs;
    Eigen::VectorXd before(rows.count);
    for (Eigen::Index i = 0; i < rows.count; ++i) {
      pairs.push_back(&distances.pairOf(i));
      before[i] = pairs.back()->distance;
    }
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      Eigen::VectorXd beside = at;
      beside[joint] += 1e-6;
      distances.update(beside);
      for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(pairs.size()); ++i) {
        const auto index = static_cast<std::size_t>(i);
        EXPECT_NEAR((pairs[index]->distance - before[i]) / 1e-6, slopes(i, joint), 1e-3);
      }
    }
  }
}

TEST(PartDistancesTest, NeighboursAndWhatTheSrdfNamesAreLeftOut) {
  const RobotPtr robot = robotNamed("humanoid");
  const PartDistances all(*robot, {}, jointsOf(*robot));
  auto other = std::make_shared<config::RobotDescription>(*robot);
  other->free_to_touch.emplace_back("right_hand", "left_hand");
  const PartDistances fewer(*other, {}, jointsOf(*other));
  EXPECT_LT(fewer.size(), all.size());
  EXPECT_THROW(PartDistances(*robot, {0.02, 0.1, {"tail"}, {}}, jointsOf(*robot)), std::runtime_error);
  EXPECT_THROW(PartDistances(*robot, {0.02, 0.1, {"left_hand"}, {}}, jointsOf(*robot)), std::runtime_error);
}

struct TwoHands {
  explicit TwoHands(const std::string& more)
      : setup(withAcceleration(robotNamed("humanoid")), R"(
chains: [left_arm, right_arm]
linear_speed: 0.3
tasks:
  left: {chain: left_arm, mask: position}
  right: {chain: right_arm, mask: position}
)" + more) {
    if (!plugin.init_control_plugin(setup)) throw std::runtime_error(setup.failure);
    EXPECT_TRUE(plugin.on_start(0).isOk());
  }

  FakeSetup setup;
  CartesianTasks plugin;
};

// The least distance that the hands have while both go to one place.
double leastDistance(TwoHands& hands, int cycles) {
  const config::RobotDescription& robot = hands.setup.robot().description();
  PartDistances seen(robot, {0.02, 0.1, {"left_hand", "right_hand", "left_forearm", "right_forearm"}, {}},
                     jointsOf(robot));
  Eigen::VectorXd at(static_cast<Eigen::Index>(robot.joints.size()));
  double least = 1;
  for (int i = 0; i < cycles; ++i) {
    run(hands.plugin, hands.setup, 1, kPeriod);
    for (Eigen::Index joint = 0; joint < at.size(); ++joint)
      at[joint] = hands.setup.robot().joint(static_cast<int>(joint)).getJointPosition();
    seen.update(at);
    least = std::min(least, seen.nearest().distance);
  }
  return least;
}

TEST(PartDistancesTest, TwoHandsThatAreSentToOnePlaceKeepTheirMargin) {
  TwoHands hands("distance: {margin: 0.03}");
  ASSERT_TRUE(hands.plugin.on_command("pose left 0.35 0 0"));
  run(hands.plugin, hands.setup, 15, kPeriod);  // not alike: what stops one hand must not be what turns the other away
  ASSERT_TRUE(hands.plugin.on_command("pose right 0.35 0 0"));
  EXPECT_GT(leastDistance(hands, kCycles), 0.028);
  const std::string status(hands.plugin.status());
  EXPECT_NE(status.find(" keep their distance; nearest are "), std::string::npos) << status;
}

// Sent to and fro, at the speed and with the period of a slow thread, before they are there.
TEST(PartDistancesTest, HandsThatAreSentAnywhereKeepTheirMargin) {
  std::mt19937 random(11);
  const auto between = [&](double least, double most) {
    return std::to_string(std::uniform_real_distribution<double>(least, most)(random));
  };
  TwoHands hands("distance: {margin: 0.03}");
  double least = 1;
  for (int i = 0; i < kTargets; ++i) {
    const std::string place = between(0.2, 0.45) + " " + between(-0.25, 0.25) + " " + between(-0.2, 0.3);
    ASSERT_TRUE(hands.plugin.on_command((i % 2 == 0 ? "pose left " : "pose right ") + place));
    least = std::min(least, leastDistance(hands, 60));
  }
  EXPECT_GT(least, 0.028);
}

TEST(PartDistancesTest, WithoutADistanceNothingStopsThem) {
  TwoHands hands("");
  ASSERT_TRUE(hands.plugin.on_command("pose left 0.35 0 0"));
  ASSERT_TRUE(hands.plugin.on_command("pose right 0.35 0 0"));
  EXPECT_LT(leastDistance(hands, kCycles), 0.01);
}

TEST(PartDistancesTest, WrongParametersAreNamed) {
  for (const char* distance :
       {"{margn: 1}", "{margin: -1}", "{links: [tail]}", "{capsules: {left_hand: {from: [0, 0], radius: 1}}}",
        "{capsules: {left_hand: {from: [0, 0, 0]}}}", "{capsules: {tail: {from: [0, 0, 0], radius: 0.1}}}"}) {
    EXPECT_ANY_THROW(TwoHands(std::string("distance: ") + distance)) << distance;
  }
}

}  // namespace
}  // namespace robotui::rt::plugins
