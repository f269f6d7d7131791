#include "robotui/rt/supervisor/master.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace robotui::rt::supervisor {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

class MasterTest : public ::testing::Test {
 protected:
  static std::string bytes(double position, std::size_t joints = 2) {
    std::vector<link::JointCommand> commands(joints);
    commands[0].position = position;
    commands[0].mode = link::kPosition;
    return {reinterpret_cast<const char*>(commands.data()), joints * sizeof(link::JointCommand)};
  }
  link::MasterData seen() {
    const auto segment = link::Segment<const link::MasterSegment>::open(master_.share());
    link::MasterData data{};
    link::MasterReader(*segment, 2).read(data);
    return data;
  }
  Master master_{2, "ROS"};
};

TEST_F(MasterTest, TakesReferencesOfOneClientOnly) {
  EXPECT_EQ(master_.take(1, "ROS", 1, 0), "");
  EXPECT_EQ(master_.take(2, "ROS", 1, 0), "Another client commands the robot now.");
  EXPECT_EQ(master_.reference(1, bytes(0.5), 100), "");
  EXPECT_NE(master_.reference(2, bytes(0.9), 100), "");
  EXPECT_DOUBLE_EQ(seen().joints[0].position, 0.5);
  EXPECT_EQ(seen().valid_until_ns, 100 + Master::kValidNs);
}

TEST_F(MasterTest, TakesReferencesOfItsFrameworkOnly) {
  EXPECT_EQ(master_.take(1, "robotui", 1, 0),
            "The master framework of this robot is ROS: references of robotui do not count. "
            "MasterCommunicationInterface.framework_name of its configuration chooses it.");
  EXPECT_NE(master_.reference(1, bytes(0.9), 100), "");
  EXPECT_FALSE(master_.holder());
  EXPECT_EQ(master_.take(2, "ROS", 1, 0), "");
}

TEST_F(MasterTest, EndsWithARelease) {
  master_.take(1, "ROS", 1, 0);
  master_.reference(1, bytes(0.5), 100);
  EXPECT_NE(master_.release(2), "");
  EXPECT_EQ(master_.release(1), "");
  EXPECT_EQ(seen().valid_until_ns, 0);
  EXPECT_EQ(master_.take(2, "ROS", 1, 0), "");
}

TEST_F(MasterTest, EndsWhenItsClientIsGoneOrSilent) {
  master_.take(1, "ROS", 1, 0);
  master_.forget(1);
  EXPECT_FALSE(master_.holder());
  master_.take(2, "ROS", 1, 0);
  EXPECT_FALSE(master_.expire(kSecond / 2));
  master_.reference(2, bytes(0.5), kSecond / 2);
  EXPECT_FALSE(master_.expire(kSecond));
  EXPECT_TRUE(master_.expire(kSecond * 3 / 2));
  EXPECT_FALSE(master_.holder());
}

TEST_F(MasterTest, RefusesBytesThatAreNoReferences) {
  master_.take(1, "ROS", 1, 0);
  EXPECT_NE(master_.reference(1, bytes(0.5, 3), 0).find("are those of 2 joints"), std::string::npos);
  EXPECT_NE(master_.reference(1, "", 0), "");
  EXPECT_NE(master_.reference(1, bytes(std::nan("")), 0).find("no number"), std::string::npos);
  EXPECT_EQ(seen().valid_until_ns, 0);
}

TEST_F(MasterTest, WantsASensibleTime) {
  EXPECT_NE(master_.take(1, "ROS", 0, 0), "");
  EXPECT_NE(master_.take(1, "ROS", std::nan(""), 0), "");
  EXPECT_NE(master_.take(1, "ROS", 1e9, 0), "");
}

}  // namespace
}  // namespace robotui::rt::supervisor
