#include <gtest/gtest.h>

#include "robotui/rt/host/hosted_plugin.h"
#include "robotui/rt/testing/fake_robot.h"

namespace robotui::rt::host {
namespace {

using Names = std::vector<std::string>;

TEST(Claims, AreTheJointsAndThoseOfTheChainsEachOnce) {
  const auto robot = testing::fakeDescription(3);
  EXPECT_EQ(claimedJoints(YAML::Load("{joints: [j3, j1]}"), *robot), (Names{"j1", "j3"}));
  EXPECT_EQ(claimedJoints(YAML::Load("{joints: [j3], chains: [arm]}"), *robot), (Names{"j1", "j2", "j3"}));
  EXPECT_EQ(claimedJoints(YAML::Load("{joints: j2}"), *robot), Names{"j2"});
  EXPECT_TRUE(claimedJoints(YAML::Load("{speed: 1}"), *robot).empty());
}

TEST(Claims, NameWhatIsNotThereAndWhatIs) {
  const auto robot = testing::fakeDescription(2);
  try {
    claimedJoints(YAML::Load("{joints: [elbow]}"), *robot);
    FAIL();
  } catch (const PluginError& e) {
    EXPECT_STREQ(e.what(), "The robot has no joint 'elbow'. It has: j1, j2.");
  }
  EXPECT_THROW(claimedJoints(YAML::Load("{chains: [leg]}"), *robot), PluginError);
  EXPECT_THROW(claimedJoints(YAML::Load("{joints: {a: 1}}"), *robot), PluginError);
}

}  // namespace
}  // namespace robotui::rt::host
