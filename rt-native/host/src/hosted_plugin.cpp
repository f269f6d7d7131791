#include "robotui/rt/host/hosted_plugin.h"

#include <algorithm>

namespace robotui::rt::host {
namespace {

using link::PluginState;

std::string sentence(const std::string& name, const std::string& what) {
  return "The plugin " + name + " cannot be made ready: " + what;
}

}  // namespace

class HostedPlugin::MakingReady final : public Setup {
 public:
  MakingReady(HostedPlugin& plugin, const config::PluginConfig& config, double period,
              const PluginEnvironment& environment)
      : plugin_(plugin),
        params_(config.params.IsDefined() && config.params.IsMap() ? config.params : YAML::Node(YAML::NodeType::Map)),
        period_(period), environment_(environment) {}

  const std::string& name() const override { return plugin_.name_; }
  const YAML::Node& params() const override { return params_; }
  double period() const override { return period_; }
  RobotInterface& robot() override { return plugin_.robot_; }
  RtLog& log() override { return plugin_.log_; }
  ChannelDirectory& channels() override { return *environment_.channels; }
  std::unique_ptr<ModelInterface> createModel() override {
    return ModelInterface::create(environment_.model_type, environment_.robot);
  }
  const link::MasterSegment& master() override { return *environment_.master; }
  void claim(const std::vector<std::string>& joints) override {
    YAML::Node wish;
    std::vector<std::string> all = plugin_.claims_;
    all.insert(all.end(), joints.begin(), joints.end());
    wish["joints"] = all;
    plugin_.claims_ = claimedJoints(wish, *environment_.robot);
    has_claimed_ = true;
  }
  void fail(const std::string& why) override { why_ = why; }
  const std::string& why() const noexcept { return why_; }
  bool hasClaimed() const noexcept { return has_claimed_; }

 private:
  HostedPlugin& plugin_;
  YAML::Node params_;
  double period_;
  const PluginEnvironment& environment_;
  std::string why_ = "its init_control_plugin returned false without a reason";
  bool has_claimed_ = false;
};

HostedPlugin::HostedPlugin(std::uint32_t index, const config::PluginConfig& config, double period,
                           const PluginEnvironment& environment, const link::FrameData& frame)
    : name_(config.name), index_(index), log_(*environment.log, index), robot_(environment.robot, frame),
      claims_(environment.kind == PluginKind::kIo ? std::vector<std::string>()
                                                  : claimedJoints(config.params, *environment.robot)),
      library_(config.type, environment.folders), plugin_(library_.create(environment.kind)) {
  init(config, period, environment);
}

HostedPlugin::~HostedPlugin() { retire(); }

bool HostedPlugin::retire() noexcept {
  if (plugin_ != nullptr) {
    succeeds("close", [&] {
      plugin_->close();
      return RtStatus::ok();
    });
    plugin_.reset();
  }
  return library_.unload();
}

void HostedPlugin::init(const config::PluginConfig& config, double period, const PluginEnvironment& environment) {
  MakingReady ready(*this, config, period, environment);
  bool made = false;
  try {
    made = plugin_->init_control_plugin(ready);
  } catch (const std::exception& e) {
    throw PluginError(sentence(name_, e.what()));
  } catch (...) {
    throw PluginError(sentence(name_, "its init_control_plugin threw something that is no std::exception"));
  }
  if (!made) {
    throw PluginError(sentence(name_, ready.why()));
  }
  settleRole(ready.hasClaimed());
}

// The `joints` and `chains` of an observer say what it looks at.
void HostedPlugin::settleRole(bool has_claimed) {
  role_ = plugin_->role();
  if (role_ != PluginRole::kObserver) return;
  if (has_claimed)
    throw PluginError(
        sentence(name_, "it is an observer and claims joints; one that commands joints has another role()"));
  claims_.clear();
}

bool HostedPlugin::order(std::uint32_t id, std::string_view words) noexcept {
  Order order{};
  order.id = id;
  order.words.assign(words);
  return orders_.push(order);
}

void HostedPlugin::arm(std::uint32_t group, std::uint64_t from, bool start) noexcept {
  ready_from_.store(from, std::memory_order_relaxed);
  armed_to_start_.store(start, std::memory_order_relaxed);
  armed_.store(group, std::memory_order_release);
}

PluginState HostedPlugin::shown() const noexcept {
  const PluginState now = state();
  const bool is_to_stop =
      armed_.load(std::memory_order_acquire) != 0 && !armed_to_start_.load(std::memory_order_relaxed);
  return is_to_stop && now == PluginState::kRunning ? PluginState::kStopping : now;
}

bool HostedPlugin::cycle(double time, double period) noexcept {
  robot_.beginCycle();
  robot_.sense();
  followGroup(time);
  startOrStop(time);
  if (state() == PluginState::kRunning) {
    succeeds("control_loop", [&] { return plugin_->control_loop(time, period); });
  }
  robot_.move();
  obey();
  report();
  return state() == PluginState::kRunning;
}

void HostedPlugin::idle(double time) noexcept {
  leaveGroup(time);
  if (!wanted_.load(std::memory_order_acquire)) {
    startOrStop(time);
  }
}

// A failure ends the plugin, not its host. An exception is one, too, though it should not be thrown here.
template <typename Step>
bool HostedPlugin::succeeds(const char* what, Step&& step) noexcept {
  try {
    const RtStatus status = step();
    if (status.isOk()) return true;
    fail({what, " of the plugin ", name_, " failed: ", status.text()});
  } catch (const std::exception& e) {
    fail({what, " of the plugin ", name_, " threw: ", e.what()});
  } catch (...) {
    fail({what, " of the plugin ", name_, " threw something that is no std::exception"});
  }
  return false;
}

void HostedPlugin::fail(std::initializer_list<std::string_view> parts) noexcept {
  failure_.assign({});
  for (const std::string_view part : parts) failure_.append(part);
  robot_.beginCycle();
  state_.store(PluginState::kFailed, std::memory_order_release);
}

// The HAL alone says when: all hosts read it in the same frame.
void HostedPlugin::followGroup(double time) noexcept {
  leaveGroup(time);
  const std::uint32_t group = armed_.load(std::memory_order_acquire);
  if (group == 0) return;
  const bool start = armed_to_start_.load(std::memory_order_relaxed);
  if (robot_.frame().switched == group) {
    wanted_.store(start, std::memory_order_release);
    if (ready_for_ == group && state() == PluginState::kStarting)
      state_.store(PluginState::kRunning, std::memory_order_release);
    ready_for_ = 0;
    armed_.store(0, std::memory_order_release);
    return;
  }
  const bool is_due =
      start && ready_for_ != group && robot_.frame().cycle >= ready_from_.load(std::memory_order_relaxed);
  if (is_due && state() == PluginState::kStopped && succeeds("on_start", [&] { return plugin_->on_start(time); })) {
    ready_for_ = group;
    state_.store(PluginState::kStarting, std::memory_order_release);
  }
}

// It was ready for a group that is not switched: its on_start is taken back.
void HostedPlugin::leaveGroup(double time) noexcept {
  if (ready_for_ == 0 || ready_for_ == armed_.load(std::memory_order_acquire)) return;
  ready_for_ = 0;
  if (state() == PluginState::kStarting) stop(time);
}

void HostedPlugin::startOrStop(double time) noexcept {
  const bool wanted = wanted_.load(std::memory_order_acquire);
  const PluginState now = state();
  if (wanted && now == PluginState::kStopped && succeeds("on_start", [&] { return plugin_->on_start(time); })) {
    state_.store(PluginState::kRunning, std::memory_order_release);
  }
  if (!wanted && now == PluginState::kRunning) stop(time);
}

void HostedPlugin::stop(double time) noexcept {
  const bool is_done = succeeds("on_stop", [&] {
    plugin_->on_stop(time);
    return RtStatus::ok();
  });
  if (is_done) state_.store(PluginState::kStopped, std::memory_order_release);
}

void HostedPlugin::obey() noexcept {
  Order order;
  while (orders_.pop(order)) {
    Answer answer{order.id, false};
    if (state() != PluginState::kFailed) {
      succeeds("on_command", [&] {
        answer.understood = plugin_->on_command(order.words.view());
        return RtStatus::ok();
      });
    }
    answers_.push(answer);
  }
}

void HostedPlugin::report() noexcept {
  const std::string_view status = state() == PluginState::kFailed ? std::string_view() : plugin_->status();
  if (status.substr(0, link::kTextLength - 1) == reported_.view()) {
    return;
  }
  Line line;
  line.assign(status);
  if (statuses_.push(line)) {
    reported_.assign(status);
  }
}

}  // namespace robotui::rt::host
