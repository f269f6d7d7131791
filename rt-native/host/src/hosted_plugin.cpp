#include "robotui/rt/host/hosted_plugin.h"

#include <algorithm>

namespace robotui::rt::host {
namespace {

using link::PluginState;

std::string sentence(const std::string& name, const std::string& what) { return "The plugin " + name + " cannot be made ready: " + what; }

}  // namespace

class HostedPlugin::Ready final : public Setup {
 public:
  Ready(HostedPlugin& plugin, const config::PluginConfig& config, double period, const PluginSurroundings& around)
      : plugin_(plugin), params_(config.params.IsDefined() && config.params.IsMap() ? config.params : YAML::Node(YAML::NodeType::Map)),
        period_(period), around_(around) {}

  const std::string& name() const override { return plugin_.name_; }
  const YAML::Node& params() const override { return params_; }
  double period() const override { return period_; }
  RobotInterface& robot() override { return plugin_.robot_; }
  RtLog& log() override { return plugin_.log_; }
  ChannelDirectory& channels() override { return *around_.channels; }
  std::unique_ptr<ModelInterface> createModel() override { return ModelInterface::create(around_.model_type, around_.robot); }
  const link::MasterSegment& master() override { return *around_.master; }
  void claim(const std::vector<std::string>& joints) override {
    YAML::Node wish;
    std::vector<std::string> all = plugin_.claims_;
    all.insert(all.end(), joints.begin(), joints.end());
    wish["joints"] = all;
    plugin_.claims_ = claimedJoints(wish, *around_.robot);
  }
  void fail(const std::string& why) override { why_ = why; }
  const std::string& why() const noexcept { return why_; }

 private:
  HostedPlugin& plugin_;
  YAML::Node params_;
  double period_;
  const PluginSurroundings& around_;
  std::string why_ = "its init_control_plugin returned false without a reason";
};

HostedPlugin::HostedPlugin(std::uint32_t index, const config::PluginConfig& config, double period, const PluginSurroundings& around,
                           const link::FrameData& frame)
    : name_(config.name), index_(index), log_(*around.log, index), robot_(around.robot, frame),
      claims_(around.kind == PluginKind::kIo ? std::vector<std::string>() : claimedJoints(config.params, *around.robot)),
      library_(config.type, around.folders), plugin_(library_.create(around.kind)) {
  init(config, period, around);
}

HostedPlugin::~HostedPlugin() { retire(); }

bool HostedPlugin::retire() noexcept {
  if (plugin_ != nullptr) {
    guarded("close", [&] { plugin_->close(); });
    plugin_.reset();
  }
  return library_.unload();
}

void HostedPlugin::init(const config::PluginConfig& config, double period, const PluginSurroundings& around) {
  Ready ready(*this, config, period, around);
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
}

bool HostedPlugin::order(std::uint32_t id, std::string_view words) noexcept {
  Order order{};
  order.id = id;
  order.words.assign(words);
  return orders_.push(order);
}

bool HostedPlugin::cycle(double time, double period) noexcept {
  robot_.beginCycle();
  robot_.sense();
  startOrStop(time);
  if (state() == PluginState::kRunning) {
    guarded("control_loop", [&] { plugin_->control_loop(time, period); });
  }
  robot_.move();
  obey();
  report();
  return state() == PluginState::kRunning;
}

void HostedPlugin::idle(double time) noexcept {
  if (!wanted_.load(std::memory_order_acquire)) {
    startOrStop(time);
  }
}

// An exception ends the plugin, not its host: what it throws for is its own matter.
template <typename Step>
bool HostedPlugin::guarded(const char* what, Step&& step) noexcept {
  try {
    step();
    return true;
  } catch (const std::exception& e) {
    failure_.assign(std::string(what) + " of the plugin " + name_ + " threw: " + e.what());
  } catch (...) {
    failure_.assign(std::string(what) + " of the plugin " + name_ + " threw something that is no std::exception");
  }
  robot_.beginCycle();
  state_.store(PluginState::kFailed, std::memory_order_release);
  return false;
}

void HostedPlugin::startOrStop(double time) noexcept {
  const bool wanted = wanted_.load(std::memory_order_acquire);
  const PluginState now = state();
  if (wanted && now == PluginState::kStopped && guarded("on_start", [&] { plugin_->on_start(time); })) {
    state_.store(PluginState::kRunning, std::memory_order_release);
  }
  if (!wanted && now == PluginState::kRunning && guarded("on_stop", [&] { plugin_->on_stop(time); })) {
    state_.store(PluginState::kStopped, std::memory_order_release);
  }
}

void HostedPlugin::obey() noexcept {
  Order order;
  while (orders_.pop(order)) {
    Answer answer{order.id, false};
    if (state() != PluginState::kFailed) {
      guarded("on_command", [&] { answer.understood = plugin_->on_command(order.words.view()); });
    }
    answers_.push(answer);
  }
}

void HostedPlugin::report() noexcept {
  const std::string_view status = state() == PluginState::kFailed ? std::string_view() : plugin_->status();
  if (status.substr(0, link::kTextLength - 1) == reported_.view()) {
    return;
  }
  Words<link::kTextLength - 1> words;
  words.assign(status);
  if (statuses_.push(words)) {
    reported_.assign(status);
  }
}

}  // namespace robotui::rt::host
