// The programs robotui-rt-hal and robotui-rt-joints, as the supervisor would start them.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/link/socket.h"
#include "robotui/rt/link/state.h"
#include "../link/temporary_folder.h"
#include "without_rights.h"

namespace robotui::rt::hal {
namespace {

using namespace std::chrono_literals;

// A child that does not outlive its test.
class Program {
 public:
  explicit Program(std::vector<std::string> arguments, bool has_rights = true) : pid_(::fork()) {
    if (pid_ != 0) return;
    if (!has_rights) dropRealTimeRights();
    std::vector<char*> raw;
    for (std::string& argument : arguments) raw.push_back(argument.data());
    raw.push_back(nullptr);
    ::execv(raw[0], raw.data());
    ::_exit(127);
  }
  ~Program() { kill(SIGKILL); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  int kill(int signal) {
    if (pid_ <= 0) return -1;
    ::kill(pid_, signal);
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return status;
  }
  int wait() {
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return status;
  }

 private:
  pid_t pid_;
};

struct HalProcess : testing::Test {
  link::Segment<link::BoardSegment> board = link::Segment<link::BoardSegment>::create(1);
  link::BoardWriter grants{*board};
  std::vector<link::Segment<link::HostSegment>> hosts;
  std::pair<link::Socket, link::Socket> sockets = link::Socket::pair();
  link::Socket& hal = sockets.first;
  std::unique_ptr<Program> program;
  link::Segment<const link::StateSegment> state;
  std::string said;  // where it failed
  TemporaryFolder folder;

  void SetUp() override {
    for (int i = 0; i < 2; ++i) hosts.push_back(link::Segment<link::HostSegment>::create(1));
  }

  void start(const std::string& config) {
    start({HAL_PROGRAM, "-C", config, "--allow-non-rt", "--period", "2000"}, true);
  }

  void start(std::vector<std::string> words, bool has_rights) {
    sockets.second.inheritable();
    words.insert(words.end(), {"--control", std::to_string(sockets.second.get())});
    program = std::make_unique<Program>(std::move(words), has_rights);
    sockets.second.close();
    const link::Descriptor given[] = {board.shareReadOnly(), hosts[0].shareReadOnly(), hosts[1].shareReadOnly()};
    const int numbers[] = {given[0].get(), given[1].get(), given[2].get()};
    ASSERT_TRUE(hal.send("begin", numbers));
    link::Packet packet;
    while (hal.receive(packet, 20s) == link::Received::kPacket) {
      if (packet.verb() == "failed") said = packet.rest();
      if (packet.verb() != "state") continue;
      state = link::Segment<const link::StateSegment>::open(std::move(packet.descriptors.at(0)));
      return;
    }
  }

  std::string config(const std::string& name) const { return std::string(CONFIGS_FOLDER) + "/arm/" + name; }

  // In a copy of the folder, so that tests that run at the same time do not meet.
  std::string configWith(const std::string& name, const std::string& old, const std::string& other) const {
    std::filesystem::copy(std::filesystem::path(CONFIGS_FOLDER) / "arm", folder.path(),
                          std::filesystem::copy_options::recursive);
    const std::filesystem::path file = folder.path() / name;
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    std::string content = text.str();
    content.replace(content.find(old), old.size(), other);
    std::ofstream(file) << content;
    return file.string();
  }

  template <class Condition>
  bool frameUntil(Condition condition) {
    link::StateReader reader(*state);
    auto frame = std::make_unique<link::FrameData>();
    for (const std::int64_t end = link::now() + 10 * link::kSecond; link::now() < end;) {
      reader.wait(link::now() + 20 * link::kMillisecond);
      if (reader.newest(*frame) == link::Read::kNew && condition(*frame)) return true;
    }
    return false;
  }
};

TEST_F(HalProcess, cycles_and_ends_when_it_is_told) {
  start(config("rt-dummy.yaml"));
  ASSERT_TRUE(state) << said;
  EXPECT_TRUE(frameUntil([](const link::FrameData& frame) { return frame.cycle > 50 && frame.hal_status == 0; }));
  EXPECT_EQ(link::relaxedLoad(state->loop.allocations), 0U);
  EXPECT_EQ(link::relaxedLoad(state->loop.period_ns), 2 * link::kMillisecond);
  ASSERT_TRUE(hal.send("end"));
  const int status = program->wait();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(state->frames[state->newest % link::kFrames].data.joints[0].control,
            static_cast<std::uint8_t>(link::Control::kSafe));
}

TEST_F(HalProcess, ends_when_its_supervisor_is_gone) {
  start(config("rt-dummy.yaml"));
  ASSERT_TRUE(state) << said;
  hal.close();
  const int status = program->wait();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST_F(HalProcess, nobody_can_write_the_state) {
  start(config("rt-dummy.yaml"));
  ASSERT_TRUE(state) << said;
  EXPECT_THROW(link::Segment<link::StateSegment>::open(state.shareReadOnly()), link::SegmentError);
}

TEST_F(HalProcess, says_what_is_wrong_with_the_configuration) {
  start("/nowhere/robot.yaml");
  EXPECT_NE(said.find("/nowhere/robot.yaml"), std::string::npos) << said;
}

TEST_F(HalProcess, passes_on_what_its_hardware_says) {
  start(configWith("rt-dummy.yaml", "type: dummy", "lib_file: " + std::string(OWN_HAL)));
  ASSERT_TRUE(state) << said;
  link::Packet packet;
  bool heard = false;
  while (!heard && hal.receive(packet, 20s) == link::Received::kPacket)
    heard = packet.text == "log warn The joints have been oiled.";
  EXPECT_TRUE(heard);
}

TEST_F(HalProcess, without_rights_it_refuses_with_the_remedy) {
  start({HAL_PROGRAM, "-C", config("rt-dummy.yaml")}, false);
  EXPECT_FALSE(state);
  EXPECT_NE(said.find("Operation not permitted"), std::string::npos) << said;
  EXPECT_NE(said.find("or start with --allow-non-rt"), std::string::npos) << said;
  const int status = program->wait();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
}

TEST_F(HalProcess, joints_over_udp_are_lost_and_found) {
  const std::string port = std::to_string(20000 + ::getpid() % 20000);
  const std::string udp = configWith("rt-udp.yaml", "9870", port);
  const auto controller = [&] {
    return std::make_unique<Program>(std::vector<std::string>{JOINTS_PROGRAM, "-C", udp, "--port", port});
  };
  auto joints = controller();
  start(udp);
  ASSERT_TRUE(state) << said;
  EXPECT_TRUE(frameUntil([](const link::FrameData& frame) { return frame.hal_status == 0; }));
  joints->kill(SIGKILL);
  EXPECT_TRUE(
      frameUntil([](const link::FrameData& frame) { return frame.hal_status == 1 && frame.joints[0].control == 3; }));
  joints = controller();
  EXPECT_TRUE(frameUntil([](const link::FrameData& frame) { return frame.hal_status == 0; }));
}

TEST(HalProgram, does_not_run_by_itself) {
  Program program({HAL_PROGRAM, "-C", "robot.yaml", "--control", "99"});
  const int status = program.wait();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2);
}

}  // namespace
}  // namespace robotui::rt::hal
