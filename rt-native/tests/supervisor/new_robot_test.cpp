// Published robots, each with a configuration as ./robotui new robot writes it, taken by the real robotui-rt: it
// starts, goes home, and moves a joint.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "homing.h"
#include "robotui/rt/config/draft.h"

namespace robotui::rt::supervisor {
namespace {

namespace fs = std::filesystem;

struct Published {
  const char* name;
  const char* urdf;
  const char* srdf;  // empty where it comes without
  const char* hardware;
};

void PrintTo(const Published& robot, std::ostream* out) { *out << robot.name << " on " << robot.hardware; }

class NewRobots : public ::testing::TestWithParam<Published> {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("ROBOTUI_SHARED");
    robots_ = fs::path(shared == nullptr ? "" : shared) / "data" / "robots";
    if (shared == nullptr || !fs::exists(robots_))
      GTEST_SKIP() << "there are no robots of others here (ROBOTUI_SHARED)";
#ifndef RT_WITH_MUJOCO
    if (std::string(GetParam().hardware) == "mujoco") GTEST_SKIP() << "built without MuJoCo";
#endif
    std::string pattern = (fs::temp_directory_path() / "rt-new-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }

  // As it is written, but for machines that run tests and are late now and then.
  YAML::Node written(const config::Draft& draft) const {
    config::writeDraft(draft, folder_ / "robot");
    YAML::Node config = YAML::LoadFile(folder_ / "robot" / ("rt-" + std::string(GetParam().hardware) + ".yaml"));
    for (const char* key : {"urdf_path", "srdf_path", "joint_map_path"})
      config["XBotInterface"][key] =
          (folder_ / "robot" / config["XBotInterface"][key].as<std::string>()).lexically_normal().string();
    config["HALInterface"]["misses_before_safe"] = 1000;
    config["xbotcore_plugins"]["Homing"]["params"]["speed"] = 1;
    return config;
  }

  fs::path robots_;
  fs::path folder_;
};

TEST_P(NewRobots, StartGoHomeAndMove) {
  const Published& which = GetParam();
  const auto srdf = std::string(which.srdf).empty() ? fs::path() : robots_ / which.srdf;
  const config::Draft draft = config::draftOf(robots_ / which.urdf, srdf, folder_ / "robot");
  RunningRobot robot(WholeConfig{YAML::Dump(written(draft))});
  robot.client();
  const auto board = robot.board();
  for (std::uint32_t i = 0; i < board->plugins; ++i) {
    const std::string name(link::view(board->plugin[i].name));
    EXPECT_TRUE(eventually([&] { return robot.stateOf(name) == link::PluginState::kStopped; }))
        << name << ": " << robot.errorOf(name);
    EXPECT_EQ(robot.errorOf(name), "") << name;
  }
  expectHomeOf(robot, goals(config::load(robot.config(), {}).robot, draft.posture));
  ASSERT_TRUE(robot.ask("switch Homing 0").ok);
  const auto begun = robot.frame();
  const auto moved = [&] { return std::abs(robot.frame()->joints[0].link_position - begun->joints[0].link_position); };
  ASSERT_TRUE(robot.ask("switch Sine 1").ok);
  EXPECT_TRUE(eventually([&] { return moved() > 0.02; })) << robot.errorOf("Sine");
}

constexpr const char* kPanda = "panda_description/urdf/panda.urdf";
constexpr const char* kPandaSrdf = "panda_description/srdf/panda.srdf";
constexpr const char* kPandaCollision = "panda_description/urdf/panda_collision.urdf";
constexpr const char* kComan = "coman_urdf/urdf/coman.urdf";
constexpr const char* kComanSrdf = "coman_urdf/srdf/coman.srdf";
constexpr const char* kHusky = "husky_description/urdf/husky.urdf";

INSTANTIATE_TEST_SUITE_P(
    Published, NewRobots,
    ::testing::Values(Published{"panda", kPanda, kPandaSrdf, "dummy"}, Published{"panda", kPanda, kPandaSrdf, "mujoco"},
                      Published{"panda_alone", kPanda, "", "dummy"},
                      Published{"panda_collision", kPandaCollision, "", "mujoco"},
                      Published{"coman", kComan, kComanSrdf, "dummy"}, Published{"coman", kComan, kComanSrdf, "mujoco"},
                      Published{"coman_alone", kComan, "", "dummy"}, Published{"husky", kHusky, "", "dummy"},
                      Published{"husky", kHusky, "", "mujoco"}),
    [](const auto& which) { return std::string(which.param.name) + "_" + which.param.hardware; });

}  // namespace
}  // namespace robotui::rt::supervisor
