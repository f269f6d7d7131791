#include "robotui/rt/host/host.h"

#include <algorithm>
#include <chrono>
#include <sstream>

#include "robotui/rt/link/board.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::host {
namespace {

using link::PluginState;

constexpr std::chrono::milliseconds kPollPeriod{5};
constexpr std::size_t kFixedDescriptors = 4;  // state, board, master, its own

PluginKind pluginKind(config::HostKind kind) {
  return kind == config::HostKind::kIo ? PluginKind::kIo : PluginKind::kControl;
}

}  // namespace

Host::Host(HostOptions options, link::Socket& supervisor, link::Packet begin)
    : options_(std::move(options)), supervisor_(supervisor) {
  openLink(begin);
  openChannels(begin);
  readPlan();
  makeThreads();
  loadAll(begin.rest());
  tell("ready");
}

Host::~Host() {
  for (auto& thread : threads_) {
    thread->stop();
  }
}

void Host::openLink(link::Packet& begin) {
  if (begin.descriptors.size() < kFixedDescriptors + 1) {
    throw std::runtime_error("The supervisor gave too few segments to this host: it is of another version.");
  }
  auto& given = begin.descriptors;
  state_ = link::Segment<const link::StateSegment>::open(std::move(given[0]));
  board_ = link::Segment<const link::BoardSegment>::open(std::move(given[1]));
  master_ = link::Segment<const link::MasterSegment>::open(std::move(given[2]));
  own_ = link::Segment<link::HostSegment>::open(std::move(given[3]));
  link::BoardReader(*board_).read(data_);
}

// The first is writable and this process's own, the others are those of all hosts.
void Host::openChannels(link::Packet& begin) {
  auto& given = begin.descriptors;
  own_channels_ = link::Segment<ChannelSegment>::open(std::move(given[kFixedDescriptors]));
  std::vector<const ChannelSegment*> all;
  for (std::size_t i = kFixedDescriptors + 1; i < given.size(); ++i) {
    channels_.push_back(link::Segment<const ChannelSegment>::openAsItIs(std::move(given[i])));
    all.push_back(channels_.back().get());
  }
  directory_ = std::make_unique<ChannelDirectory>(*own_channels_, std::move(all));
}

void Host::readPlan() {
  config::RtConfig config = config::load(options_.config, options_.overrides);
  plan_ = config::plan(config, options_.communication);
  checkBoard(plan_);
  environment_.robot = std::make_shared<const config::RobotDescription>(std::move(config.robot));
  environment_.model_type = config.model_type;
  environment_.folders = pluginFolders(options_.config);
  environment_.channels = directory_.get();
  environment_.master = master_.get();
  environment_.log = &log_;
  environment_.kind = pluginKind(plan_.hosts[options_.host].kind);
}

// The supervisor read the file before: who edits it meanwhile may change parameters, but not who runs what.
void Host::checkBoard(const config::Plan& plan) const {
  bool same = options_.host < plan.hosts.size() && plan.plugins.size() == data_.plugins;
  for (std::uint32_t i = 0; same && i < data_.plugins; ++i) {
    const auto& there = data_.plugin[i];
    same = link::view(there.name) == plan.plugins[i].plugin.name && there.host == plan.plugins[i].host &&
           there.thread == plan.plugins[i].thread;
  }
  if (!same) {
    throw std::runtime_error("The plugins or threads in " + options_.config.string() +
                             " have changed since the start: start robotui-rt again.");
  }
}

void Host::makeThreads() {
  const config::HostPlan& mine = plan_.hosts[options_.host];
  own_->threads = static_cast<std::uint32_t>(mine.threads.size());
  for (std::uint32_t i = 0; i < mine.threads.size(); ++i) {
    const config::ThreadConfig& thread = mine.threads[i];
    const bool real_time = data_.real_time != 0 && thread.scheduling != config::Scheduling::kOther;
    ThreadPlan plan{thread.name,
                    i,
                    std::chrono::nanoseconds(thread.period).count(),
                    real_time ? thread.priority : 0,
                    thread.core,
                    mine.kind == config::HostKind::kIo,
                    thread.runtime};
    threads_.push_back(std::make_unique<PluginThread>(std::move(plan), *state_, *board_, *own_));
  }
  for (auto& thread : threads_) {
    thread->start();
  }
}

void Host::loadAll(std::string_view skipped) {
  for (std::uint32_t i = 0; i < plan_.plugins.size(); ++i) {
    const config::PluginPlan& planned = plan_.plugins[i];
    if (planned.host != options_.host) {
      continue;
    }
    Hosted hosted;
    hosted.name = planned.plugin.name;
    hosted.index = i;
    hosted.thread = planned.thread;
    own_->plugins[i].thread = planned.thread;
    if (link::containsWord(skipped, hosted.name)) {
      fail(hosted, "The plugin " + hosted.name +
                       " is not loaded, because it ended its process again and again while it was made ready.");
    } else {
      load(hosted);
    }
    plugins_.push_back(std::move(hosted));
  }
}

void Host::load(Hosted& hosted) {
  tell("loading " + hosted.name);
  link::StateReader(*state_).newest(snapshot_);
  PluginThread& thread = *threads_[hosted.thread];
  try {
    hosted.plugin =
        std::make_unique<HostedPlugin>(hosted.index, plan_.plugins[hosted.index].plugin,
                                       static_cast<double>(thread.plan().period_ns) * 1e-9, environment_, snapshot_);
  } catch (const std::exception& e) {
    fail(hosted, e.what());
    return;
  }
  hosted.told = PluginState::kStopped;
  std::string words = "loaded " + hosted.name + " " + std::string(link::nameOf(hosted.plugin->role()));
  for (const std::string& joint : hosted.plugin->claims()) {
    words += " " + joint;
  }
  hosted.plugin->follow(thread.frame());
  thread.attach(*hosted.plugin);
  own_->plugins[hosted.index].state.store(static_cast<std::uint32_t>(PluginState::kStopped), std::memory_order_relaxed);
  tell(words);
}

void Host::run() {
  for (bool going = true; going;) {
    link::Packet packet;
    switch (supervisor_.receive(packet, kPollPeriod)) {
      case link::Received::kPacket: going = obey(packet); break;
      case link::Received::kClosed: going = false; break;
      case link::Received::kTimeout: break;
    }
    poll();
  }
  for (Hosted& hosted : plugins_) {
    unload(hosted);
  }
  pollLog();
}

bool Host::obey(const link::Packet& packet) {
  const std::string_view verb = packet.verb();
  if (verb == "end") {
    return false;
  }
  if (verb == "command") {
    command(packet.rest());
    return true;
  }
  if (verb == "arm" || verb == "disarm") {
    switchWithOthers(packet.rest(), verb == "arm");
    return true;
  }
  Hosted* hosted = find(packet.rest());
  if (hosted == nullptr) {
    tell("log warn the host does not understand '" + packet.text + "'");
  } else if (verb == "start" || verb == "stop") {
    want(*hosted, verb == "start");
  } else if (verb == "reload") {
    reload(*hosted);
  }
  return true;
}

void Host::want(Hosted& hosted, bool running) {
  if (hosted.plugin == nullptr) {
    tell("failed " + hosted.name + " The plugin " + hosted.name + " is not loaded.");
    return;
  }
  hosted.plugin->want(running);
  hosted.told = running ? PluginState::kStarting : PluginState::kStopping;
}

// "GROUP FROM P 1|0", or "P".
void Host::switchWithOthers(std::string_view words, bool arm) {
  std::istringstream text{std::string(words)};
  std::uint32_t group = 0;
  std::uint64_t from = 0;
  std::string name;
  int start = 0;
  arm ? text >> group >> from >> name >> start : text >> name;
  Hosted* hosted = find(name);
  if (text.fail() || hosted == nullptr || hosted->plugin == nullptr) {
    tell("log warn the host does not understand '" + std::string(words) + "'");
  } else if (arm) {
    hosted->plugin->arm(group, from, start == 1);
    hosted->told = start == 1 ? PluginState::kStarting : PluginState::kStopping;
  } else {
    hosted->plugin->disarm();
    const bool was_to_start = hosted->told == PluginState::kStarting;
    const bool was_to_stop = hosted->told == PluginState::kStopping;
    hosted->told = was_to_start ? PluginState::kStopping : was_to_stop ? PluginState::kRunning : hosted->told;
  }
}

void Host::command(std::string_view words) {
  const auto [id, behind] = link::splitWord(words);
  const auto [name, order] = link::splitWord(behind);
  Hosted* hosted = find(name);
  const auto number = static_cast<std::uint32_t>(std::strtoul(std::string(id).c_str(), nullptr, 10));
  if (hosted == nullptr || hosted->plugin == nullptr || !hosted->plugin->order(number, order)) {
    tell("answer " + std::string(id) + " refused");
  }
}

// Stops it first where it runs: the thread lets go between two cycles.
void Host::unload(Hosted& hosted) { unloadForReload(hosted); }

std::string Host::unloadForReload(Hosted& hosted) {
  if (hosted.plugin == nullptr) {
    return {};
  }
  hosted.plugin->disarm();
  hosted.plugin->want(false);
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  while (hosted.plugin->state() == PluginState::kRunning && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  threads_[hosted.thread]->detach(*hosted.plugin);
  own_->plugins[hosted.index].state.store(static_cast<std::uint32_t>(PluginState::kAbsent), std::memory_order_relaxed);
  const bool gone = hosted.plugin->retire();
  hosted.plugin.reset();
  return gone ? std::string()
              : "The library of the plugin " + hosted.name +
                    " stays in memory, so that a new one would not be seen: build it with -fno-gnu-unique, or end its "
                    "host to load it anew.";
}

void Host::reload(Hosted& hosted) {
  const std::string stuck = unloadForReload(hosted);
  if (!stuck.empty()) {
    fail(hosted, stuck);
    return;
  }
  try {
    config::Plan plan = config::plan(config::load(options_.config, options_.overrides), options_.communication);
    checkBoard(plan);
    plan_ = std::move(plan);
  } catch (const std::exception& e) {
    fail(hosted, e.what());
    return;
  }
  load(hosted);
}

void Host::poll() {
  for (Hosted& hosted : plugins_) {
    if (hosted.plugin != nullptr) {
      pollState(hosted);
    }
  }
  pollLog();
}

void Host::pollState(Hosted& hosted) {
  const PluginState now = hosted.plugin->state();
  if (now == PluginState::kFailed && hosted.told != PluginState::kFailed) {
    hosted.told = now;
    tell("failed " + hosted.name + " " + hosted.plugin->failure());
  } else if (now == PluginState::kRunning && hosted.told == PluginState::kStarting) {
    hosted.told = now;
    tell("started " + hosted.name);
  } else if (now == PluginState::kStopped && hosted.told == PluginState::kStopping) {
    hosted.told = now;
    tell("stopped " + hosted.name);
  }
  HostedPlugin::Answer answer;
  while (hosted.plugin->takeAnswer(answer)) {
    tell("answer " + std::to_string(answer.id) + (answer.understood ? " ok" : " refused"));
  }
  HostedPlugin::Line status;
  while (hosted.plugin->takeStatus(status)) {
    tell("status " + hosted.name + " " + std::string(status.view()));
  }
}

void Host::pollLog() {
  LogQueue::Line line;
  while (log_.pop(line)) {
    const std::string name = line.source < plan_.plugins.size() ? plan_.plugins[line.source].plugin.name : "?";
    tell("log " + std::string(robotui::rt::nameOf(line.level)) + " " + name + ": " + std::string(line.view()));
  }
  if (const std::uint64_t lost = log_.takeLost(); lost > 0) {
    tell("log warn " + std::to_string(lost) + " lines of plugins found no room in the log");
  }
}

void Host::fail(Hosted& hosted, const std::string& sentence) {
  hosted.told = PluginState::kFailed;
  own_->plugins[hosted.index].state.store(static_cast<std::uint32_t>(PluginState::kFailed), std::memory_order_relaxed);
  tell("failed " + hosted.name + " " + sentence);
}

// A supervisor that is gone is seen by receive.
void Host::tell(const std::string& words) { supervisor_.send(words); }

Host::Hosted* Host::find(std::string_view name) {
  const auto found =
      std::find_if(plugins_.begin(), plugins_.end(), [&](const Hosted& hosted) { return hosted.name == name; });
  return found == plugins_.end() ? nullptr : &*found;
}

}  // namespace robotui::rt::host
