#include "running_robot.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/state.h"
#include "without_rights.h"

namespace robotui::rt::supervisor {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kReply{20000};
std::atomic<int> count{0};

int codeOf(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// On a busy machine the writer may have to wait in the middle of its writing, for longer than a reader tries.
void untilItIsRead(const std::function<link::Read()>& read) {
  if (!eventually([&] { return read() != link::Read::kBusy; }))
    throw std::runtime_error("the writer died while it wrote");
}

}  // namespace

WholeConfig simulatedArm(const std::string& blocks, int misses_before_safe, const std::string& hardware) {
  const std::string arm = std::string(RT_CONFIGS) + "/arm/";
  return {"XBotInterface: {urdf_path: " + arm + "arm.urdf, srdf_path: " + arm + "arm.srdf, joint_map_path: " + arm +
          "joint_map.yaml}\nHALInterface: {type: dummy, misses_before_safe: " + std::to_string(misses_before_safe) +
          (hardware.empty() ? "" : ", " + hardware) + "}\n" + blocks};
}

bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

RunningRobot::RunningRobot(const std::string& blocks, std::vector<std::string> options, Rights rights)
    : RunningRobot(simulatedArm(blocks), std::move(options), rights) {}

RunningRobot::RunningRobot(const WholeConfig& config, std::vector<std::string> options, Rights rights)
    : name_("test-" + std::to_string(::getpid()) + "-" + std::to_string(++count)),
      folder_(fs::temp_directory_path() / ("robotui-" + name_)), config_(folder_ / "robot.yaml"),
      options_(std::move(options)), rights_(rights) {
  fs::create_directories(folder_);
  std::ofstream(config_) << config.yaml;
  ::setenv("XDG_RUNTIME_DIR", fs::temp_directory_path().c_str(), 1);
  ::setenv("XDG_STATE_HOME", folder_.c_str(), 1);
  ::setenv("ROBOTUI_RT_PLUGINS", RT_PLUGINS, 1);
  pid_ = start(folder_ / "output");
}

RunningRobot::~RunningRobot() {
  end(SIGTERM);
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

pid_t RunningRobot::start(const fs::path& output) const {
  std::vector<std::string> words{std::string(RT_BIN) + "/robotui-rt", "-C", config_.string(), "--name", name_};
  words.insert(words.end(), options_.begin(), options_.end());
  std::vector<char*> raw;
  for (std::string& word : words) {
    raw.push_back(word.data());
  }
  raw.push_back(nullptr);
  const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::dup2(file, STDERR_FILENO);
    if (rights_ == Rights::kNone) dropRealTimeRights();
    ::execv(raw[0], raw.data());
    ::_exit(127);
  }
  ::close(file);
  return pid;
}

link::Client& RunningRobot::client() {
  eventually([&] {
    try {
      if (client_ == nullptr || client_->notice(std::chrono::milliseconds(0)) == link::Notice::kGone) {
        client_ = std::make_unique<link::Client>(name_, kReply);
      }
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  });
  if (client_ == nullptr) {
    throw std::runtime_error("robotui-rt did not start: " + output());
  }
  return *client_;
}

link::Reply RunningRobot::ask(const std::string& words) { return client().request(words, kReply); }

link::Attachment RunningRobot::attach() {
  std::optional<link::Attachment> attachment;
  eventually([&] {
    try {
      attachment = client().attach(kReply);
    } catch (const std::runtime_error&) {
    }
    return attachment.has_value();
  });
  return std::move(attachment).value();
}

std::unique_ptr<link::BoardData> RunningRobot::board() {
  auto data = std::make_unique<link::BoardData>();
  const auto attachment = attach();
  link::BoardReader reader(*attachment.board);
  untilItIsRead([&] { return reader.read(*data); });
  return data;
}

std::unique_ptr<link::FrameData> RunningRobot::frame() {
  auto data = std::make_unique<link::FrameData>();
  const auto attachment = attach();
  link::StateReader reader(*attachment.state);
  untilItIsRead([&] { return reader.newest(*data); });
  return data;
}

std::uint32_t RunningRobot::plugin(const std::string& name) {
  const auto data = board();
  for (std::uint32_t i = 0; i < data->plugins; ++i) {
    if (link::view(data->plugin[i].name) == name) {
      return i;
    }
  }
  throw std::runtime_error("no plugin " + name);
}

link::PluginState RunningRobot::stateOf(const std::string& name) {
  return static_cast<link::PluginState>(board()->plugin[plugin(name)].state);
}

std::string RunningRobot::errorOf(const std::string& name) {
  return std::string(link::view(board()->plugin[plugin(name)].error));
}

std::optional<int> RunningRobot::end(int signal, std::chrono::milliseconds patience) {
  if (pid_ > 0) {
    ::kill(pid_, signal);
  }
  return outcome(patience);
}

std::optional<int> RunningRobot::outcome(std::chrono::milliseconds patience) {
  if (pid_ <= 0) {
    return std::nullopt;
  }
  int status = 0;
  const bool ended = eventually([&] { return ::waitpid(pid_, &status, WNOHANG) == pid_; }, patience);
  if (!ended) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, &status, 0);
  }
  pid_ = -1;
  return ended ? std::optional(codeOf(status)) : std::nullopt;
}

std::string RunningRobot::output() const { return read(folder_ / "output"); }

std::pair<int, std::string> RunningRobot::ctl(const std::string& words) const {
  const fs::path file = folder_ / "ctl";
  const std::string line =
      std::string(RT_BIN) + "/robotui-rt-ctl --name " + name_ + " " + words + " >" + file.string() + " 2>&1";
  const int code = codeOf(std::system(line.c_str()));
  return {code, read(file)};
}

std::pair<int, std::string> RunningRobot::second() const {
  const fs::path file = folder_ / "second";
  const pid_t pid = start(file);
  int status = 0;
  ::waitpid(pid, &status, 0);
  return {codeOf(status), read(file)};
}

}  // namespace robotui::rt::supervisor
