// What clients ask as the master framework: to become it, to be it no more, and the references that they then send.
#pragma once

#include <cstdint>
#include <string_view>

#include "robotui/rt/supervisor/client_replies.h"
#include "robotui/rt/supervisor/log_file.h"
#include "robotui/rt/supervisor/master.h"
#include "robotui/rt/supervisor/plugin_registry.h"

namespace robotui::rt::supervisor {

class MasterRequests {
 public:
  // `enabled` is false with --no-ch: then nobody can be it.
  MasterRequests(Master& master, const PluginRegistry& registry, bool enabled, ClientReplies& replies, LogFile& log)
      : master_(master), registry_(registry), enabled_(enabled), replies_(replies), log_(log) {}

  void take(std::uint64_t client, std::string_view words);
  void release(std::uint64_t client);

  // The plugin that follows references now, or a sentence why none does.
  void follower(std::uint64_t client);

  // Has no reply; what is wrong with it goes to the log, once a second.
  void reference(std::uint64_t client, std::string_view bytes);

 private:
  Master& master_;
  const PluginRegistry& registry_;
  bool enabled_;
  ClientReplies& replies_;
  LogFile& log_;
  std::int64_t complained_ns_ = 0;
};

}  // namespace robotui::rt::supervisor
