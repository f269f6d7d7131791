#include "robotui/rt/supervisor/plugin_registry.h"

#include <gtest/gtest.h>

#include "fake_config.h"

namespace robotui::rt::supervisor {
namespace {

using link::PluginRole;

class PluginRegistryTest : public ::testing::Test {
 protected:
  PluginRegistryTest() {
    load("homing", PluginRole::kControl, "j1 j2 j3 j4");
    load("sine", PluginRole::kControl, "j1");
    load("reach", PluginRole::kControl, "j2 j3");
    load("log", PluginRole::kObserver, "");
    load("bridge", PluginRole::kMaster, "j1 j2 j3 j4");
    load("slowly", PluginRole::kControl, "j4");
    load("face", PluginRole::kObserver, "");
  }

  void load(std::string_view name, PluginRole role, std::string_view joints) {
    registry_.loaded(at(name), role, joints);
  }
  std::uint32_t at(std::string_view name) { return *registry_.find(name); }
  void run(std::string_view name) {
    ASSERT_EQ(registry_.objection(at(name)), "");
    registry_.starting(at(name));
    registry_.started(at(name));
  }

  config::RtConfig config_ = fakeConfig();
  config::Plan plan_ = config::plan(config_, {});
  BoardPublisher board_{config_, plan_, true};
  PluginRegistry registry_{config_, plan_, board_};
};

TEST_F(PluginRegistryTest, GivesAPluginItsJointsAndTakesThemBack) {
  run("reach");
  EXPECT_EQ(board_.owner(0), link::kNobody);
  EXPECT_EQ(board_.owner(1), at("reach"));
  EXPECT_EQ(board_.owner(2), at("reach"));
  registry_.stopped(at("reach"));
  EXPECT_EQ(board_.owner(1), link::kNobody);
}

TEST_F(PluginRegistryTest, RefusesAStartWhileAnotherPluginOwnsAJointAndNamesBoth) {
  run("reach");
  EXPECT_EQ(registry_.objection(at("homing")),
            "homing cannot be started while reach runs: both command the joint j2. Stop reach first.");
  EXPECT_EQ(registry_.objection(at("sine")), "");
  registry_.stopped(at("reach"));
  EXPECT_EQ(registry_.objection(at("homing")), "");
}

TEST_F(PluginRegistryTest, StartsTheMasterOnlyWhenTheOthersAreStoppedObserversAside) {
  run("log");
  run("sine");
  EXPECT_EQ(registry_.objection(at("bridge")),
            "bridge cannot be started while other plugins run (sine): the master framework commands the whole robot. "
            "Stop them first.");
  registry_.stopped(at("sine"));
  run("bridge");
}

TEST_F(PluginRegistryTest, StartsOthersOnlyWhenTheMasterIsStopped) {
  run("bridge");
  EXPECT_EQ(registry_.objection(at("sine")),
            "sine cannot be started while bridge runs: the master framework commands the robot. "
            "Stop bridge first.");
  EXPECT_EQ(registry_.objection(at("log")), "");
  EXPECT_EQ(registry_.objection(at("face")), "");
}

TEST_F(PluginRegistryTest, LeavesTheJointsOfAFailedPluginSafeAndGivesThemToTheNext) {
  run("reach");
  registry_.failed(at("reach"), "control_loop threw");
  EXPECT_EQ(board_.owner(1), at("reach"));
  EXPECT_EQ(registry_.objection(at("reach")), "reach has failed and must be reloaded first: control_loop threw");
  const std::uint32_t grant =
      link::BoardReader(*link::Segment<const link::BoardSegment>::open(board_.share())).grant(1);
  run("homing");
  EXPECT_EQ(board_.owner(1), at("homing"));
  EXPECT_GT(link::BoardReader(*link::Segment<const link::BoardSegment>::open(board_.share())).grant(1), grant);
}

TEST_F(PluginRegistryTest, KeepsWhyAPluginWasLostUntilItIsStartedAgain) {
  run("reach");
  registry_.lost(at("reach"), "Its host died.");
  EXPECT_EQ(registry_.objection(at("reach")), "reach is not loaded yet: its host starts.");
  load("reach", PluginRole::kControl, "j2 j3");
  EXPECT_EQ(registry_.describe(at("reach")), "stopped: Its host died.");
  run("reach");
  EXPECT_EQ(registry_.describe(at("reach")), "running");
  registry_.setStatus(at("reach"), "40 %");
  EXPECT_EQ(registry_.describe(at("reach")), "running: 40 %");
}

TEST_F(PluginRegistryTest, OneThatFellKeepsItsJointsAndWhyUntilItIsStartedAgain) {
  run("reach");
  registry_.fell(at("reach"), "It was late.");
  EXPECT_EQ(registry_.describe(at("reach")), "stopping: It was late.");
  registry_.stopped(at("reach"));
  EXPECT_EQ(registry_.describe(at("reach")), "stopped: It was late.");
  EXPECT_EQ(board_.owner(1), at("reach"));
  EXPECT_EQ(registry_.objection(at("homing")), "") << "its joints are for the next one";
  registry_.lost(at("reach"), "");
  EXPECT_EQ(registry_.describe(at("reach")), "absent: It was late.");
  load("reach", PluginRole::kControl, "j2 j3");
  run("reach");
  EXPECT_EQ(registry_.describe(at("reach")), "running");
}

TEST_F(PluginRegistryTest, TakesTheJointsOfOneThatIsToStopBeforeItAnswers) {
  run("reach");
  registry_.stopping(at("reach"));
  EXPECT_EQ(board_.owner(1), link::kNobody);
}

TEST_F(PluginRegistryTest, KnowsWhoFollowsReferences) { EXPECT_EQ(registry_.masterPlugin(), at("bridge")); }

TEST_F(PluginRegistryTest, NamesWhatThereIsWhereAPluginIsNotKnown) {
  EXPECT_FALSE(registry_.find("dance"));
  EXPECT_EQ(registry_.unknown("dance"),
            "There is no plugin 'dance'. There are: homing, sine, reach, log, bridge, slowly, face.");
}

}  // namespace
}  // namespace robotui::rt::supervisor
