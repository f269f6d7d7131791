// A whole robotui-rt in a folder of its own: the arm as a kinematic simulation, or what a configuration says.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotui/rt/link/client.h"

namespace robotui::rt::supervisor {

// Waits for it, with patience for a loaded machine; false where it never came.
bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds patience = std::chrono::seconds(60));

// YAML that says all.
struct WholeConfig {
  std::string yaml;
};

// The arm as a kinematic simulation. A plugin may be late as often as that, where it is not the misses that are looked
// at.
// `hardware` are more keys of its HAL.
WholeConfig simulatedArm(const std::string& blocks, int misses_before_safe = 2, const std::string& hardware = {});

enum class Rights { kAsTheyAre, kNone };

// It goes on where it lacks rights, unless its options say otherwise.
class RunningRobot {
 public:
  // `blocks` is YAML behind those of the robot: threads and plugins.
  explicit RunningRobot(const std::string& blocks, std::vector<std::string> options = {"--allow-non-rt"},
                        Rights rights = Rights::kAsTheyAre);
  explicit RunningRobot(const WholeConfig& config, std::vector<std::string> options = {"--allow-non-rt"},
                        Rights rights = Rights::kAsTheyAre);
  ~RunningRobot();
  RunningRobot(const RunningRobot&) = delete;
  RunningRobot& operator=(const RunningRobot&) = delete;

  const std::string& name() const noexcept { return name_; }
  const std::filesystem::path& config() const noexcept { return config_; }
  pid_t pid() const noexcept { return pid_; }

  // Connects as soon as it answers.
  link::Client& client();
  link::Reply ask(const std::string& words);
  std::unique_ptr<link::BoardData> board();
  std::unique_ptr<link::FrameData> frame();
  link::Attachment attach();
  std::uint32_t plugin(const std::string& name);
  link::PluginState stateOf(const std::string& name);
  std::string errorOf(const std::string& name);

  // Sends the signal and waits: the exit code, or 128 + the signal.
  std::optional<int> end(int signal, std::chrono::milliseconds patience = std::chrono::seconds(20));
  // Waits for it to end by itself: as end().
  std::optional<int> outcome(std::chrono::milliseconds patience = std::chrono::seconds(20));
  // What it wrote to stderr so far.
  std::string output() const;

  // robotui-rt-ctl with these words: its exit code, and all that it said.
  std::pair<int, std::string> ctl(const std::string& words) const;

  // Starts another one of the same name: its exit code and what it said.
  std::pair<int, std::string> second() const;

 private:
  pid_t start(const std::filesystem::path& output) const;

  std::string name_;
  std::filesystem::path folder_;
  std::filesystem::path config_;
  std::vector<std::string> options_;
  Rights rights_;
  pid_t pid_ = -1;
  std::unique_ptr<link::Client> client_;
};

}  // namespace robotui::rt::supervisor
