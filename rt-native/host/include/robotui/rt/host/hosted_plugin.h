// One plugin in its host: the object, its library and its robot, and what the threads of the host tell each other about it.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"
#include "robotui/rt/host/link_robot.h"
#include "robotui/rt/host/mailbox.h"
#include "robotui/rt/host/plugin_library.h"
#include "robotui/rt/plugin/log_queue.h"

namespace robotui::rt::host {

// What all plugins of a host share. Outlives them.
struct PluginSurroundings {
  std::shared_ptr<const config::RobotDescription> robot;
  std::string model_type;
  std::vector<std::filesystem::path> folders;
  ChannelDirectory* channels;
  const link::MasterSegment* master;
  LogQueue* log;
  PluginKind kind;
};

class HostedPlugin {
 public:
  struct Order {
    std::uint32_t id;
    Words<496> words;
  };
  struct Answer {
    std::uint32_t id;
    bool understood;
  };

  // Loads and initialises; throws PluginError with a sentence. `index` is that on the board, `frame` what it senses meanwhile.
  HostedPlugin(std::uint32_t index, const config::PluginConfig& config, double period, const PluginSurroundings& around,
               const link::FrameData& frame);
  ~HostedPlugin();  // the thread must have let go
  HostedPlugin(const HostedPlugin&) = delete;
  HostedPlugin& operator=(const HostedPlugin&) = delete;

  // ---- of the ordinary thread
  void follow(const link::FrameData& frame) noexcept { robot_.follow(frame); }  // of its thread, before that knows it
  const std::string& name() const noexcept { return name_; }
  std::uint32_t index() const noexcept { return index_; }
  const std::vector<std::string>& claims() const noexcept { return claims_; }
  // Closes and unloads, once the thread has let go. False where the library stays in memory, so that a changed one would not be seen.
  bool retire() noexcept;
  void want(bool running) noexcept { wanted_.store(running, std::memory_order_release); }
  bool order(std::uint32_t id, std::string_view words) noexcept;
  bool takeAnswer(Answer& answer) noexcept { return answers_.pop(answer); }
  bool takeStatus(Words<link::kTextLength - 1>& status) noexcept { return statuses_.pop(status); }
  link::PluginState state() const noexcept { return state_.load(std::memory_order_acquire); }
  std::string failure() const { return std::string(failure_.view()); }  // once the state is kFailed

  // ---- of its real-time thread, once a cycle. True where it ran, so that outgoing() holds its commands.
  bool cycle(double time, double period) noexcept;
  // Where the robot does not cycle: only stops.
  void idle(double time) noexcept;
  std::span<const link::JointCommand> outgoing() const noexcept { return robot_.outgoing(); }

 private:
  class Ready;
  template <typename Step>
  bool guarded(const char* what, Step&& step) noexcept;
  void init(const config::PluginConfig& config, double period, const PluginSurroundings& around);
  void startOrStop(double time) noexcept;
  void obey() noexcept;
  void report() noexcept;

  const std::string name_;
  const std::uint32_t index_;
  TaggedLog log_;
  LinkRobot robot_;
  std::vector<std::string> claims_;
  PluginLibrary library_;
  std::unique_ptr<ControlPlugin> plugin_;

  std::atomic<bool> wanted_{false};
  std::atomic<link::PluginState> state_{link::PluginState::kStopped};
  Words<link::kTextLength - 1> failure_;
  Words<link::kTextLength - 1> reported_;
  Mailbox<Order, 16> orders_;
  Mailbox<Answer, 16> answers_;
  Mailbox<Words<link::kTextLength - 1>, 4> statuses_;
};

// `joints` and `chains` of a plugin's parameters as names of joints, each once, in the robot's order. Throws PluginError.
std::vector<std::string> claimedJoints(const YAML::Node& params, const config::RobotDescription& robot);

}  // namespace robotui::rt::host
