// The plugins: their states, the joints they claim, and which may be started beside which.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotui/rt/link/plugin_role.h"
#include "robotui/rt/supervisor/board_publisher.h"

namespace robotui::rt::supervisor {

// Plugins that are started and stopped together.
struct PluginGroup {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> stop;
};

class PluginRegistry {
 public:
  PluginRegistry(const config::RtConfig& config, const config::Plan& plan, BoardPublisher& board);

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(plugins_.size()); }
  std::optional<std::uint32_t> find(std::string_view name) const;
  const std::string& name(std::uint32_t plugin) const { return plugins_[plugin].name; }
  link::PluginState state(std::uint32_t plugin) const;
  std::uint32_t host(std::uint32_t plugin) const { return plan_.plugins[plugin].host; }
  bool isIo(std::uint32_t plugin) const;
  bool hasJoints(std::uint32_t plugin) const { return !plugins_[plugin].joints.empty(); }
  std::uint32_t grantOf(std::uint32_t joint) const noexcept { return board_.grantOf(joint); }
  bool isActive(std::uint32_t plugin) const;          // starting, running or stopping
  std::optional<std::uint32_t> masterPlugin() const;  // that passes on references, the running one first
  std::vector<std::uint32_t> ofHost(std::uint32_t host) const;
  std::string unknown(std::string_view name) const;  // the sentence for it

  const std::vector<std::uint32_t>& jointsOf(std::uint32_t plugin) const { return plugins_[plugin].joints; }

  // Empty, or a sentence why it may not be started now, with the others of a group: its own state, a joint that another
  // plugin owns, or the master.
  std::string objection(std::uint32_t plugin, const PluginGroup& with = {}) const;

  // What its host said: its role, and the joints that it claims. An unknown joint is left out: the host checked them.
  void loaded(std::uint32_t plugin, link::PluginRole role, std::string_view joints);
  // Gives it its joints.
  void starting(std::uint32_t plugin);
  // It is to be started with others, and gets its joints when they are switched.
  void preparing(std::uint32_t plugin);
  // The HAL leads its joints by it already: the board follows.
  void handOver(std::uint32_t plugin);
  // The HAL has taken from it already what it owned.
  void left(std::uint32_t plugin);
  void started(std::uint32_t plugin);
  // Its joints hold from now on, whatever its process still does.
  void stopping(std::uint32_t plugin);
  // The HAL put its joints into their safe state: it is being stopped, and `sentence` stays until it is started again.
  void fell(std::uint32_t plugin, std::string_view sentence);
  // Its joints are nobody's, and hold; those of one that fell stay its own, and safe.
  void stopped(std::uint32_t plugin);
  // Its joints stay its own, and safe, until it or another one is started.
  void failed(std::uint32_t plugin, std::string_view sentence);
  // Its host died: as failed, but it comes back as stopped; `sentence` stays until it is started.
  void lost(std::uint32_t plugin, std::string_view sentence);

  void setStatus(std::uint32_t plugin, std::string_view line);
  // "running: LINE", "failed: SENTENCE", or the state alone.
  std::string describe(std::uint32_t plugin) const;

 private:
  struct Plugin {
    std::string name;
    link::PluginRole role;
    std::vector<std::uint32_t> joints;
  };

  bool isBeside(std::uint32_t other, const PluginGroup& with) const;
  std::string masterObjection(std::uint32_t plugin, const PluginGroup& with) const;
  std::string jointObjection(std::uint32_t plugin, const PluginGroup& with) const;
  std::string groupObjection(std::uint32_t plugin, const PluginGroup& with) const;
  void releaseJoints(std::uint32_t plugin);
  void set(std::uint32_t plugin, link::PluginState state, std::string_view error);

  const config::RtConfig& config_;
  const config::Plan& plan_;
  BoardPublisher& board_;
  std::vector<Plugin> plugins_;
};

std::string_view nameOf(link::PluginState state) noexcept;

}  // namespace robotui::rt::supervisor
