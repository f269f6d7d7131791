// One plugin in its host: the object, its library and its robot, and what the threads of the host tell each other about
// it.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"
#include "robotui/rt/host/link_robot.h"
#include "robotui/rt/host/plugin_library.h"
#include "robotui/rt/link/spsc_queue.h"
#include "robotui/rt/link/fixed_text.h"
#include "robotui/rt/plugin/log_queue.h"

namespace robotui::rt::host {

// What all plugins of a host share. Outlives them.
struct PluginEnvironment {
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
  using Line = link::FixedText<link::kTextLength - 1>;
  struct Order {
    std::uint32_t id;
    link::FixedText<496> words;
  };
  struct Answer {
    std::uint32_t id;
    bool understood;
  };

  // Loads and initialises; throws PluginError with a sentence. `index` is that on the board, `frame` what it senses
  // meanwhile.
  HostedPlugin(std::uint32_t index, const config::PluginConfig& config, double period,
               const PluginEnvironment& environment, const link::FrameData& frame);
  ~HostedPlugin();  // the thread must have let go
  HostedPlugin(const HostedPlugin&) = delete;
  HostedPlugin& operator=(const HostedPlugin&) = delete;

  // ---- of the ordinary thread
  void follow(const link::FrameData& frame) noexcept { robot_.follow(frame); }  // of its thread, before that knows it
  const std::string& name() const noexcept { return name_; }
  std::uint32_t index() const noexcept { return index_; }
  const std::vector<std::string>& claims() const noexcept { return claims_; }
  PluginRole role() const noexcept { return role_; }
  // Closes and unloads, once the thread has let go. False where the library stays in memory, so that a changed one
  // would not be seen.
  bool retire() noexcept;
  void want(bool running) noexcept { wanted_.store(running, std::memory_order_release); }
  // It is started or stopped together with others, in the cycle in which the HAL says that the group of this number is
  // switched; from the cycle `from` on a plugin that is to be started gets itself ready by its on_start.
  void arm(std::uint32_t group, std::uint64_t from, bool start) noexcept;
  // The group is not switched: all is as before.
  void disarm() noexcept { armed_.store(0, std::memory_order_release); }
  // As all processes see it: ready to be started is kStarting, and ready to be stopped is kStopping.
  link::PluginState shown() const noexcept;
  bool order(std::uint32_t id, std::string_view words) noexcept;
  bool takeAnswer(Answer& answer) noexcept { return answers_.pop(answer); }
  bool takeStatus(Line& status) noexcept { return statuses_.pop(status); }
  link::PluginState state() const noexcept { return state_.load(std::memory_order_acquire); }
  std::string failure() const { return std::string(failure_.view()); }  // once the state is kFailed

  // ---- of its real-time thread, once a cycle. True where it ran, so that outgoing() holds its commands.
  bool cycle(double time, double period) noexcept;
  // Where the robot does not cycle: only stops.
  void idle(double time) noexcept;
  std::span<const link::JointCommand> outgoing() const noexcept { return robot_.outgoing(); }

 private:
  class MakingReady;
  template <typename Step>
  bool succeeds(const char* what, Step&& step) noexcept;
  void fail(std::initializer_list<std::string_view> parts) noexcept;
  void settleRole(bool has_claimed);
  void init(const config::PluginConfig& config, double period, const PluginEnvironment& environment);
  void startOrStop(double time) noexcept;
  void stop(double time) noexcept;
  void followGroup(double time) noexcept;
  void leaveGroup(double time) noexcept;
  void obey() noexcept;
  void report() noexcept;

  const std::string name_;
  const std::uint32_t index_;
  TaggedLog log_;
  LinkRobot robot_;
  std::vector<std::string> claims_;
  PluginLibrary library_;
  std::unique_ptr<ControlPlugin> plugin_;
  PluginRole role_ = PluginRole::kControl;

  std::atomic<bool> wanted_{false};
  std::atomic<std::uint32_t> armed_{0};  // the group that it is switched with; 0 is none
  std::atomic<std::uint64_t> ready_from_{0};
  std::atomic<bool> armed_to_start_{false};
  std::uint32_t ready_for_ = 0;  // the group for which its on_start was called
  std::atomic<link::PluginState> state_{link::PluginState::kStopped};
  Line failure_;
  Line reported_;
  link::SpscQueue<Order, 16> orders_;
  link::SpscQueue<Answer, 16> answers_;
  link::SpscQueue<Line, 4> statuses_;
};

// `joints` and `chains` of a plugin's parameters as names of joints, each once, in the robot's order. Throws
// PluginError.
std::vector<std::string> claimedJoints(const YAML::Node& params, const config::RobotDescription& robot);

}  // namespace robotui::rt::host
