#include "robotui/rt/supervisor/host_process.h"

#include <signal.h>

#include <algorithm>
#include <cstring>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/host_damage.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::int64_t kLoadingNs = 60 * link::kSecond;
constexpr int kMostDeathsAtLoading = 2;

}  // namespace

HostProcess::HostProcess(std::uint32_t index, const config::HostPlan& plan)
    : index_(index), plan_(plan), segment_(link::Segment<link::HostSegment>::create(0)),
      channels_(link::Segment<link::ChannelSegment>::create(1)), channel_header_(channels_->header) {}

void HostProcess::spawn(const std::vector<std::string>& arguments, const std::vector<int>& common,
                        const std::vector<int>& channels) {
  segment_ = link::Segment<link::HostSegment>::create(++generation_);
  header_ = segment_->header;
  damage_.clear();
  resetChannels();
  progress_.assign(plan_.threads.size(), {});
  ready_ = false;
  broken_ = false;
  loading_.clear();
  loading_since_ = link::now();
  std::vector<std::string> all = arguments;
  all.insert(all.end(), {"--host", std::to_string(index_)});
  child_.spawn(programBeside("robotui-rt-host"), std::move(all), SIGKILL);
  const link::Descriptor own = segment_.shareWritable();
  const link::Descriptor own_channels = channels_.shareWritable();
  std::vector<int> given = common;
  given.insert(given.end(), {own.get(), own_channels.get()});
  given.insert(given.end(), channels.begin(), channels.end());
  std::string words = "begin";
  for (const auto& [plugin, deaths] : deaths_at_loading_) {
    words += deaths >= kMostDeathsAtLoading ? " " + plugin : "";
  }
  child_.socket().send(words, given);
}

// Readers must not find what was written there, also where it is not started again.
void HostProcess::restore() {
  segment_ = link::Segment<link::HostSegment>::create(++generation_);
  header_ = segment_->header;
  resetChannels();
}

// Its memory outlives it, since others have mapped it: nothing of the process before may stay.
void HostProcess::resetChannels() {
  for (link::ChannelSlot& slot : channels_->slots) {
    slot.id.store(0, std::memory_order_release);
    slot.name.fill(0);
  }
  channels_->header = channel_header_;
}

void HostProcess::handle(const link::Packet& packet, std::int64_t now_ns) {
  const std::string_view verb = packet.verb();
  if (verb == "loading") {
    loading_ = packet.rest();
    loading_since_ = now_ns;
  } else if (verb == "loaded" || verb == "failed") {
    loading_.clear();
  } else if (verb == "ready") {
    ready_ = true;
    deaths_at_loading_.clear();
  } else if (verb == "unable") {
    broken_ = true;
    broken_why_ = packet.rest();
  }
}

void HostProcess::watch(std::uint64_t hal_cycle, std::int64_t hal_period_ns, std::int64_t patience_ns,
                        std::int64_t now_ns) {
  if (!child_.isAlive()) {
    return;
  }
  if (damage_.empty() && !(damage_ = damage()).empty()) {
    child_.kill("its memory was damaged (" + damage_ + "): a plugin of it wrote where it must not");
  }
  if (!loading_.empty() && now_ns - loading_since_ > kLoadingNs) {
    child_.kill("the plugin " + loading_ + " was not made ready within a minute");
  }
  for (std::uint32_t i = 0; ready_ && i < progress_.size(); ++i) {
    if (isStuck(i, hal_cycle, hal_period_ns, patience_ns)) {
      child_.kill("its thread " + plan_.threads[i].name + " did not answer any more");
    }
  }
}

// What a plugin could write is what this process wrote before, or what the host may write there.
std::string HostProcess::damage() const {
  const auto isSame = [](const link::Header& now, const link::Header& then) {
    return std::memcmp(&now, &then, sizeof(now)) == 0;
  };
  const std::string damage = link::damageOf(*segment_);
  if (!damage.empty()) return damage;
  if (!isSame(link::relaxedCopy(segment_->header), header_)) return "its head is overwritten";
  if (!isSame(link::relaxedCopy(channels_->header), channel_header_)) return "the head of its channels is overwritten";
  const std::uint32_t threads = link::relaxedLoad(segment_->threads);
  return ready_ && threads != plan_.threads.size() ? "the number of its threads is overwritten" : "";
}

bool HostProcess::isStuck(std::uint32_t thread, std::uint64_t hal_cycle, std::int64_t hal_period_ns,
                          std::int64_t patience_ns) {
  Progress& last = progress_[thread];
  const std::uint64_t cycles = link::relaxedLoad(segment_->thread_statistics[thread].cycles);
  if (cycles != last.cycles || hal_cycle < last.hal_cycle || last.hal_cycle == 0) {
    last = {cycles, hal_cycle};
    return false;
  }
  const std::int64_t own = std::chrono::nanoseconds(plan_.threads[thread].period).count();
  const auto silent = static_cast<std::int64_t>(hal_cycle - last.hal_cycle) * hal_period_ns;
  return plan_.kind != config::HostKind::kIo && silent > std::max(patience_ns, 5 * own);
}

HostProcess::Death HostProcess::ended(const std::string& how, std::int64_t now_ns,
                                      const std::function<std::string(std::uint32_t)>& name_of) {
  Death death;
  death.sentence = "The process of the host " + plan_.name + " " + how;
  if (broken_) {
    death.sentence = broken_why_;
  } else if (!loading_.empty()) {
    deaths_at_loading_[loading_] += 1;
    death.sentence += " while the plugin " + loading_ + " was made ready";
  }
  std::string at_work;
  for (std::uint32_t i = 0; i < plan_.threads.size(); ++i) {
    const std::uint32_t plugin = segment_->thread_statistics[i].inside.load(std::memory_order_relaxed);
    if (generation_ != 0 && ready_ && damage_.empty() && plugin < link::kMaxPlugins &&
        death.at_work.insert(plugin).second) {
      at_work += (at_work.empty() ? " in the plugin " : " or ") + name_of(plugin);
    }
  }
  death.sentence += broken_ ? "" : at_work + ".";
  ready_ = false;
  loading_.clear();
  respawns_.ended(now_ns);
  if (!damage_.empty()) restore();
  return death;
}

}  // namespace robotui::rt::supervisor
