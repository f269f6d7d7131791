// A process that runs the plugins of one host, and obeys its supervisor.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotui/rt/config/plan.h"
#include "robotui/rt/host/hosted_plugin.h"
#include "robotui/rt/host/plugin_thread.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/link/socket.h"

namespace robotui::rt::host {

struct HostOptions {
  std::filesystem::path config;
  config::Overrides overrides;
  config::Communication communication;
  std::uint32_t host = 0;  // index of the plan
};

// The ordinary thread of the process. Everything but the cycles happens here.
class Host {
 public:
  // Throws std::runtime_error, config::ConfigError, link::SegmentError with sentences.
  Host(HostOptions options, link::Socket& supervisor, link::Packet begin);
  ~Host();

  // Until the supervisor ends it or is gone.
  void run();

 private:
  struct Hosted {
    std::string name;
    std::uint32_t index = 0;  // on the board
    std::uint32_t thread = 0;
    std::unique_ptr<HostedPlugin> plugin;  // none: it could not be loaded
    link::PluginState told = link::PluginState::kAbsent;
  };

  void openLink(link::Packet& begin);
  void openChannels(link::Packet& begin);
  void readPlan();
  void checkBoard(const config::Plan& plan) const;
  void makeThreads();
  void loadAll(std::string_view skipped);
  void load(Hosted& hosted);
  void unload(Hosted& hosted);
  std::string unloadForReload(Hosted& hosted);
  bool obey(const link::Packet& packet);
  void reload(Hosted& hosted);
  void command(std::string_view words);
  void switchWithOthers(std::string_view words, bool arm);
  void want(Hosted& hosted, bool running);
  void poll();
  void pollState(Hosted& hosted);
  void pollLog();
  void fail(Hosted& hosted, const std::string& sentence);
  void tell(const std::string& words);
  Hosted* find(std::string_view name);

  HostOptions options_;
  link::Socket& supervisor_;
  link::Segment<const link::StateSegment> state_;
  link::Segment<const link::BoardSegment> board_;
  link::Segment<const link::MasterSegment> master_;
  link::Segment<link::HostSegment> own_;
  link::Segment<ChannelSegment> own_channels_;
  std::vector<link::Segment<const ChannelSegment>> channels_;
  std::unique_ptr<ChannelDirectory> directory_;
  link::BoardData data_{};
  LogQueue log_;
  config::Plan plan_;
  link::FrameData snapshot_{};
  PluginEnvironment environment_;
  std::vector<Hosted> plugins_;
  std::vector<std::unique_ptr<PluginThread>> threads_;  // behind the plugins: they end first
};

}  // namespace robotui::rt::host
