#include "robotui/rt/supervisor/roster.h"

#include <gtest/gtest.h>

#include "fake_config.h"

namespace robotui::rt::supervisor {
namespace {

using link::PluginState;

class RosterTest : public ::testing::Test {
 protected:
  RosterTest() {
    for (const auto& [name, joints] : {std::pair{"homing", "j1 j2 j3 j4"}, {"sine", "j1"}, {"reach", "j2 j3"}, {"log", ""},
                                       {"XBotCommunicationPlugin", "j1 j2 j3 j4"}, {"slowly", "j4"}, {"face", ""}}) {
      roster_.loaded(*roster_.find(name), joints);
    }
  }

  std::uint32_t at(std::string_view name) { return *roster_.find(name); }
  void run(std::string_view name) {
    ASSERT_EQ(roster_.objection(at(name)), "");
    roster_.starting(at(name));
    roster_.started(at(name));
  }

  config::RtConfig config_ = fakeConfig();
  config::Plan plan_ = config::plan(config_, {});
  BoardKeeper board_{config_, plan_, true};
  Roster roster_{config_, plan_, board_};
};

TEST_F(RosterTest, GivesAPluginItsJointsAndTakesThemBack) {
  run("reach");
  EXPECT_EQ(board_.owner(0), link::kNobody);
  EXPECT_EQ(board_.owner(1), at("reach"));
  EXPECT_EQ(board_.owner(2), at("reach"));
  roster_.stopped(at("reach"));
  EXPECT_EQ(board_.owner(1), link::kNobody);
}

TEST_F(RosterTest, RefusesAStartWhileAnotherPluginOwnsAJointAndNamesBoth) {
  run("reach");
  EXPECT_EQ(roster_.objection(at("homing")),
            "homing cannot be started while reach runs: both command the joint j2. Stop reach first.");
  EXPECT_EQ(roster_.objection(at("sine")), "");
  roster_.stopped(at("reach"));
  EXPECT_EQ(roster_.objection(at("homing")), "");
}

TEST_F(RosterTest, StartsTheCommunicationPluginOnlyWhenTheOthersAreStoppedLoggingAside) {
  run("log");
  run("sine");
  EXPECT_EQ(roster_.objection(at("XBotCommunicationPlugin")),
            "XBotCommunicationPlugin cannot be started while other plugins run (sine): the master framework commands the whole robot. Stop them first.");
  roster_.stopped(at("sine"));
  run("XBotCommunicationPlugin");
}

TEST_F(RosterTest, StartsOthersOnlyWhenTheCommunicationPluginIsStopped) {
  run("XBotCommunicationPlugin");
  EXPECT_EQ(roster_.objection(at("sine")), "sine cannot be started while XBotCommunicationPlugin runs: the master framework commands the robot. "
                                           "Stop XBotCommunicationPlugin first.");
  EXPECT_EQ(roster_.objection(at("log")), "");
  EXPECT_EQ(roster_.objection(at("face")), "");
}

TEST_F(RosterTest, LeavesTheJointsOfAFailedPluginSafeAndGivesThemToTheNext) {
  run("reach");
  roster_.failed(at("reach"), "control_loop threw");
  EXPECT_EQ(board_.owner(1), at("reach"));
  EXPECT_EQ(roster_.objection(at("reach")), "reach has failed and must be reloaded first: control_loop threw");
  const std::uint32_t grant = link::BoardReader(*link::Segment<const link::BoardSegment>::open(board_.share())).grant(1);
  run("homing");
  EXPECT_EQ(board_.owner(1), at("homing"));
  EXPECT_GT(link::BoardReader(*link::Segment<const link::BoardSegment>::open(board_.share())).grant(1), grant);
}

TEST_F(RosterTest, KeepsWhyAPluginWasLostUntilItIsStartedAgain) {
  run("reach");
  roster_.lost(at("reach"), "Its host died.");
  EXPECT_EQ(roster_.objection(at("reach")), "reach is not loaded yet: its host starts.");
  roster_.loaded(at("reach"), "j2 j3");
  EXPECT_EQ(roster_.describe(at("reach")), "stopped: Its host died.");
  run("reach");
  EXPECT_EQ(roster_.describe(at("reach")), "running");
  roster_.setStatus(at("reach"), "40 %");
  EXPECT_EQ(roster_.describe(at("reach")), "running: 40 %");
}

TEST_F(RosterTest, NamesWhatThereIsWhereAPluginIsNotKnown) {
  EXPECT_FALSE(roster_.find("dance"));
  EXPECT_EQ(roster_.unknown("dance"), "There is no plugin 'dance'. There are: homing, sine, reach, log, XBotCommunicationPlugin, slowly, face.");
}

}  // namespace
}  // namespace robotui::rt::supervisor
