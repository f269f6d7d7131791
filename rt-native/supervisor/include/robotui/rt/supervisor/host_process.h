// One host as the supervisor sees it: started, given its memory, watched, and started again when it died.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "robotui/rt/config/plan.h"
#include "robotui/rt/link/channels.h"
#include "robotui/rt/link/segment.h"
#include "robotui/rt/supervisor/child.h"
#include "robotui/rt/supervisor/respawn.h"

namespace robotui::rt::supervisor {

class HostProcess {
 public:
  HostProcess(std::uint32_t index, const config::HostPlan& plan);

  // Starts the process with a segment of its own; `common` are state, board and master, `channels` those of all hosts.
  // Throws std::runtime_error.
  void spawn(const std::vector<std::string>& arguments, const std::vector<int>& common,
             const std::vector<int>& channels);

  const std::string& name() const noexcept { return plan_.name; }
  Child& child() noexcept { return child_; }
  const RespawnPolicy& respawns() const noexcept { return respawns_; }
  const link::Segment<link::HostSegment>& segment() const noexcept { return segment_; }
  const link::Segment<link::ChannelSegment>& channels() const noexcept { return channels_; }
  bool isReady() const noexcept { return ready_; }
  bool isBroken() const noexcept { return broken_; }  // it said that it cannot run: not started again by itself
  bool isGivenUp() const noexcept { return broken_ || respawns_.isGivenUp(); }
  // The user wants it again.
  void resetDeaths() noexcept {
    broken_ = false;
    respawns_.reset();
  }

  // Notes what concerns the process as such; the rest is for others.
  void handle(const link::Packet& packet, std::int64_t now_ns);

  // Kills it where a plugin has overwritten its memory, or where it got stuck: a thread that does not cycle for
  // `patience_ns` of the robot's cycles, or a plugin that is never made ready.
  void watch(std::uint64_t hal_cycle, std::int64_t hal_period_ns, std::int64_t patience_ns, std::int64_t now_ns);

  // After its death: the sentence for the user, and the plugins that were at work then.
  struct Death {
    std::string sentence;
    std::set<std::uint32_t> at_work;
  };
  Death ended(const std::string& how, std::int64_t now_ns, const std::function<std::string(std::uint32_t)>& name_of);

 private:
  struct Progress {
    std::uint64_t cycles = 0;
    std::uint64_t hal_cycle = 0;
  };
  void restore();
  void resetChannels();
  std::string damage() const;
  bool isStuck(std::uint32_t thread, std::uint64_t hal_cycle, std::int64_t hal_period_ns, std::int64_t patience_ns);

  std::uint32_t index_;
  const config::HostPlan& plan_;
  Child child_;
  RespawnPolicy respawns_;
  link::Segment<link::HostSegment> segment_;
  link::Segment<link::ChannelSegment> channels_;
  link::Header header_{};
  link::Header channel_header_;
  std::string damage_;  // for which it was killed
  std::uint32_t generation_ = 0;
  bool ready_ = false;
  bool broken_ = false;
  std::string broken_why_;
  std::string loading_;
  std::int64_t loading_since_ = 0;
  std::map<std::string, int> deaths_at_loading_;
  std::vector<Progress> progress_;
};

}  // namespace robotui::rt::supervisor
