#include "robotui/rt/link/board.h"

#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace robotui::rt::link {
namespace {

struct Board : testing::Test {
  std::unique_ptr<BoardSegment> segment = std::make_unique<BoardSegment>();
  BoardWriter writer{*segment};
  BoardReader reader{*segment};
  std::unique_ptr<BoardData> out = std::make_unique<BoardData>();
};

TEST_F(Board, shows_what_was_published_and_nothing_before) {
  assign(writer.edit().robot, "arm");
  EXPECT_EQ(reader.read(*out), Read::kNone);
  writer.publish();
  EXPECT_EQ(reader.read(*out), Read::kNew);
  EXPECT_EQ(view(out->robot), "arm");
  EXPECT_EQ(reader.read(*out), Read::kSame);
}

TEST_F(Board, a_joint_is_nobodys_until_it_is_granted) {
  EXPECT_EQ(reader.owner(7), kNobody);
  const std::uint32_t before = reader.grant(7);
  writer.grant(7, 3);
  EXPECT_EQ(reader.grant(7), before + 1);
  EXPECT_EQ(reader.owner(7), 3);
  writer.release(7);
  EXPECT_EQ(reader.owner(7), kNobody);
  EXPECT_EQ(reader.grant(7), before + 1);
}

TEST_F(Board, counts_of_a_hostile_one_stay_within_the_layout) {
  BoardData& data = writer.edit();
  data.joints = data.imus = data.force_torques = data.hosts = data.plugins = UINT32_MAX;
  writer.publish();
  ASSERT_EQ(reader.read(*out), Read::kNew);
  EXPECT_EQ(out->joints, kMaxJoints);
  EXPECT_EQ(out->hosts, kMaxHosts);
  EXPECT_EQ(out->plugins, kMaxPlugins);
}

TEST_F(Board, is_never_read_torn) {
  constexpr std::int32_t kTimes = 300;
  std::jthread writing([&] {
    for (std::int32_t i = 1; i <= kTimes; ++i) {
      writer.edit().hal_pid = i;
      writer.edit().plugin[kMaxPlugins - 1].respawns = static_cast<std::uint32_t>(i);
      writer.publish();
    }
  });
  while (out->hal_pid < kTimes) {
    if (reader.read(*out) == Read::kNew) {
      ASSERT_EQ(static_cast<std::uint32_t>(out->hal_pid), out->plugin[kMaxPlugins - 1].respawns);
    }
  }
}

TEST(BoardText, is_cut_between_characters) {
  Name name;
  assign(name, std::string(62, 'a') + "\u00e4");  // two bytes, of which only one would fit
  EXPECT_EQ(view(name), std::string(62, 'a'));
  assign(name, std::string(61, 'a') + "\u00e4");
  EXPECT_EQ(view(name).size(), 63U);
}

TEST(BoardText, without_an_end_is_all_there_is) {
  Name name;
  name.fill('x');
  EXPECT_EQ(view(name).size(), kNameLength);
}

}  // namespace
}  // namespace robotui::rt::link
