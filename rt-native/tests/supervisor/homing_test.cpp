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
#include <string>
#include <vector>

#include "homing.h"

namespace robotui::rt::supervisor {
namespace {

namespace fs = std::filesystem;

// What simulates the other side of a HAL, until the test is over. `format` is that of what it says when it is ready.
class OtherSide {
 public:
  OtherSide(const std::string& name, const std::vector<std::string>& options, const char* format) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    pid_ = ::fork();
    if (pid_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::dup2(ends[1], STDOUT_FILENO);
      std::string program = std::string(RT_BIN) + "/" + name;
      std::vector<std::string> words = options;
      std::vector<char*> raw{program.data()};
      for (std::string& word : words) raw.push_back(word.data());
      raw.push_back(nullptr);
      ::execv(program.c_str(), raw.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    const std::unique_ptr<FILE, int (*)(FILE*)> said(::fdopen(ends[0], "r"), ::fclose);
    if (std::fscanf(said.get(), format, &number_) != 1) throw std::runtime_error(name + " did not start");
  }
  ~OtherSide() {
    ::kill(pid_, SIGTERM);
    ::waitpid(pid_, nullptr, 0);
  }
  OtherSide(const OtherSide&) = delete;
  OtherSide& operator=(const OtherSide&) = delete;

  int number() const noexcept { return number_; }

 private:
  pid_t pid_ = -1;
  int number_ = 0;
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
  const std::string file = (fs::path(RT_CONFIGS) / robot / ("rt-" + hardware + ".yaml")).string();
  std::unique_ptr<OtherSide> other;
  if (hardware == "udp") {
    other = std::make_unique<OtherSide>("robotui-rt-joints", std::vector<std::string>{"-C", file, "--port", "0"},
                                        "port %d");
    config["HALInterface"]["params"]["port"] = other->number();
  }
  if (hardware == "canopen") {
    const std::string bus = "unix:" + (fs::temp_directory_path() / ("can-" + std::to_string(::getpid()))).string();
    other = std::make_unique<OtherSide>("robotui-rt-drives", std::vector<std::string>{"-C", file, "--interface", bus},
                                        "drives %d");
    config["HALInterface"]["params"]["interface"] = bus;
    config["HALInterface"]["params"]["missed_pdos"] = 1000;
    config["HALInterface"]["params"]["heartbeat_timeout_ms"] = 20'000;
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
                                           std::pair{"arm", "udp"}, std::pair{"arm", "canopen"},
                                           std::pair{"humanoid", "dummy"}, std::pair{"humanoid", "mujoco"},
                                           std::pair{"humanoid", "udp"}),
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
