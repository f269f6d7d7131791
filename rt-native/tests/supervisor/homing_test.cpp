// One Homing, the same library, for every robot on every hardware: nothing but the configuration differs.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>

#include "robotui/rt/config/config.h"
#include "robotui/rt/link/board.h"
#include "robotui/rt/link/state.h"
#include "running_robot.h"

namespace robotui::rt::supervisor {
namespace {

namespace fs = std::filesystem;

constexpr double kNear = 0.02;  // rad: joints of the simulation with forces give way a little
constexpr double kSomeWay = 0.3;

// The simulated joint controller, at a free port, for as long as the test goes on.
class JointController {
 public:
  explicit JointController(const fs::path& config) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    pid_ = ::fork();
    if (pid_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::dup2(ends[1], STDOUT_FILENO);
      const std::string program = std::string(RT_BIN) + "/robotui-rt-joints";
      ::execl(program.c_str(), program.c_str(), "-C", config.c_str(), "--port", "0", nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    const std::unique_ptr<FILE, int (*)(FILE*)> said(::fdopen(ends[0], "r"), ::fclose);
    if (std::fscanf(said.get(), "port %d", &port_) != 1) throw std::runtime_error("robotui-rt-joints did not start");
  }
  ~JointController() {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  JointController(const JointController&) = delete;
  JointController& operator=(const JointController&) = delete;

  int port() const noexcept { return port_; }

 private:
  pid_t pid_ = -1;
  int port_ = 0;
};

// As it is shipped, but from anywhere, in haste, and without a word about machines that run tests and are late now and
// then.
YAML::Node shipped(const std::string& robot, const std::string& hardware) {
  const fs::path folder = fs::path(RT_CONFIGS) / robot;
  YAML::Node config = YAML::LoadFile(folder / ("rt-" + hardware + ".yaml"));
  for (const char* key : {"urdf_path", "srdf_path", "joint_map_path"}) {
    config["XBotInterface"][key] = (folder / config["XBotInterface"][key].as<std::string>()).string();
  }
  config["MasterCommunicationInterface"]["framework_name"] = "robotui";
  config["HALInterface"]["misses_before_safe"] = 1000;
  config["xbotcore_plugins"]["Homing"]["params"]["speed"] = 1;
  return config;
}

// A robot of somebody else, with no more than a configuration needs.
YAML::Node foreign(const fs::path& urdf, const fs::path& srdf, const fs::path& joint_map, const std::string& posture) {
  YAML::Node config;
  config["XBotInterface"]["urdf_path"] = urdf.string();
  config["XBotInterface"]["srdf_path"] = srdf.string();
  config["XBotInterface"]["joint_map_path"] = joint_map.string();
  config["HALInterface"]["type"] = "dummy";
  config["HALInterface"]["misses_before_safe"] = 1000;
  YAML::Node homing;
  homing["name"] = "Homing";
  homing["params"]["posture"] = posture;
  homing["params"]["speed"] = 1;
  config["XBotRTPlugins"]["plugins"].push_back(homing);
  return config;
}

// Where the joints of a posture are to be, within their limits.
std::map<std::string, double> goals(const config::RobotDescription& robot, const std::string& posture) {
  std::map<std::string, double> wanted;
  for (const config::Posture& each : robot.postures) {
    for (const auto& [name, position] : each.joints) {
      const auto joint =
          std::find_if(robot.joints.begin(), robot.joints.end(), [&](const auto& j) { return j.name == name; });
      if (each.name == posture && joint != robot.joints.end())
        wanted[name] = std::clamp(position, joint->lower, joint->upper);
    }
  }
  return wanted;
}

// How far the joint that is farthest from its goal is away from it.
double farthest(RunningRobot& robot, const std::map<std::string, double>& wanted) {
  const auto board = robot.board();
  const auto frame = robot.frame();
  double most = 0;
  for (std::uint32_t i = 0; i < board->joints; ++i) {
    const auto goal = wanted.find(std::string(link::view(board->joint[i].name)));
    if (goal != wanted.end()) most = std::max(most, std::abs(frame->joints[i].link_position - goal->second));
  }
  return most;
}

void expectHome(const YAML::Node& config, const std::string& posture) {
  RunningRobot robot(WholeConfig{YAML::Dump(config)});
  robot.client();
  const auto wanted = goals(config::load(robot.config(), {}).robot, posture);
  ASSERT_FALSE(wanted.empty());
  EXPECT_GT(farthest(robot, wanted), kSomeWay) << "it must have some way to go";
  const auto started = robot.ask("switch Homing 1");
  ASSERT_TRUE(started.ok) << started.text << robot.output();
  EXPECT_TRUE(eventually([&] { return farthest(robot, wanted) < kNear; }))
      << farthest(robot, wanted) << " from home; " << robot.output();
  EXPECT_TRUE(eventually([&] { return robot.ask("status Homing").text == "running: at home"; }))
      << robot.ask("status Homing").text;
}

class OneHoming : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(OneHoming, TakesTheRobotHome) {
  const std::string robot = GetParam().first;
  const std::string hardware = GetParam().second;
  YAML::Node config = shipped(robot, hardware);
  std::unique_ptr<JointController> controller;
  if (hardware == "udp") {
    controller = std::make_unique<JointController>(fs::path(RT_CONFIGS) / robot / "rt-udp.yaml");
    config["HALInterface"]["params"]["port"] = controller->port();
  }
  if (hardware == "mujoco") {
#ifndef RT_WITH_MUJOCO
    GTEST_SKIP() << "built without MuJoCo";
#endif
    config["HALInterface"]["params"]["posture"] = "upright";
  }
  expectHome(config, "home");
}

INSTANTIATE_TEST_SUITE_P(Everywhere, OneHoming,
                         ::testing::Values(std::pair{"arm", "dummy"}, std::pair{"arm", "mujoco"},
                                           std::pair{"arm", "udp"}, std::pair{"humanoid", "dummy"},
                                           std::pair{"humanoid", "mujoco"}, std::pair{"humanoid", "udp"}),
                         [](const auto& which) { return std::string(which.param.first) + "_" + which.param.second; });

class ForeignRobots : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("ROBOTUI_SHARED");
    if (shared == nullptr) GTEST_SKIP() << "ROBOTUI_SHARED is not set: there are no robots of others here";
    robots_ = fs::path(shared) / "data" / "robots";
    if (!fs::exists(robots_)) GTEST_SKIP() << robots_ << " is not there";
  }
  fs::path robots_;
};

// The Panda comes without a joint map.
TEST_F(ForeignRobots, ThePandaGoesHome) {
  const fs::path map = fs::temp_directory_path() / ("robotui-panda-" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(map) << "joint_map: {1: panda_joint1, 2: panda_joint2, 3: panda_joint3, 4: panda_joint4, 5: "
                        "panda_joint5, 6: panda_joint6, 7: panda_joint7}\n";
  const fs::path folder = robots_ / "panda_description";
  expectHome(foreign(folder / "urdf/panda.urdf", folder / "srdf/panda.srdf", map, "default"), "default");
  fs::remove(map);
}

TEST_F(ForeignRobots, TheComanGoesHome) {
  const fs::path folder = robots_ / "coman_urdf";
  YAML::Node config =
      foreign(folder / "urdf/coman.urdf", folder / "srdf/coman.srdf", folder / "config/coman_joint_map.yaml", "home");
  config["ModelInterface"]["is_model_floating_base"] = true;
  expectHome(config, "home");
}

}  // namespace
}  // namespace robotui::rt::supervisor
