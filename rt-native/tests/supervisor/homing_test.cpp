// One Homing, the same library, for every robot on every hardware: nothing but the configuration differs.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <fstream>
#include <memory>

#include "homing.h"

namespace robotui::rt::supervisor {
namespace {

namespace fs = std::filesystem;

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
