#include "command_inbox.h"

#include <algorithm>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::hal {

struct CommandInbox::Host {
  Host(HostView memory, std::uint32_t joints) : segment(std::move(memory)) {
    for (std::uint32_t i = 0; i < link::kMaxThreads; ++i) readers.emplace_back(*segment, i, joints);
  }
  HostView segment;
  std::vector<link::SlotReader> readers;
};

bool Waiting::isOver(std::int64_t deadline_ns) const noexcept { return link::now() >= deadline_ns; }

bool Waiting::await(const link::SlotReader& slot, std::int64_t deadline_ns) noexcept { return slot.wait(deadline_ns); }

CommandInbox::CommandInbox(CommandPlan plan, std::uint32_t joints, std::uint32_t misses_before_safe, Waiting& waiting)
    : waiting_(&waiting), joints_(joints), misses_before_safe_(misses_before_safe), start_cycles_(plan.start_cycles),
      threads_(plan.threads.size()), thread_of_plugin_(std::move(plan.thread_of_plugin)) {
  for (std::size_t i = 0; i < threads_.size(); ++i) threads_[i].plan = plan.threads[i];
}

CommandInbox::~CommandInbox() {
  for (auto* const places : {&offered_, &retired_}) {
    for (auto& place : *places) delete place.load();
  }
}

// The real-time thread takes over nothing before its last one was taken away, so one place is enough: emptied before,
// for the thread to go on, and behind, for what it retired in between.
void CommandInbox::offer(std::uint32_t host, HostView segment) {
  if (host >= link::kMaxHosts) return;
  delete retired_[host].exchange(nullptr, std::memory_order_acq_rel);
  delete offered_[host].exchange(new Host(std::move(segment), joints_), std::memory_order_acq_rel);
  delete retired_[host].exchange(nullptr, std::memory_order_acq_rel);
}

void CommandInbox::adopt(std::size_t host) noexcept {
  if (retired_[host].load(std::memory_order_acquire) != nullptr) return;
  Host* const offered = offered_[host].exchange(nullptr, std::memory_order_acq_rel);
  if (offered == nullptr) return;
  retired_[host].store(hosts_[host].release(), std::memory_order_release);
  hosts_[host].reset(offered);
  for (Thread& thread : threads_) {
    if (thread.plan.host == host) thread.answered = 0;
  }
}

void CommandInbox::begin() noexcept {
  for (std::size_t i = 0; i < link::kMaxHosts; ++i) adopt(i);
  for (Thread& thread : threads_) thread.wanted = thread.heard = false;
}

CommandInbox::Thread* CommandInbox::threadOf(std::uint16_t plugin) noexcept {
  if (plugin >= thread_of_plugin_.size() || thread_of_plugin_[plugin] >= threads_.size()) return nullptr;
  return &threads_[thread_of_plugin_[plugin]];
}

const CommandInbox::Thread* CommandInbox::threadOf(std::uint16_t plugin) const noexcept {
  return const_cast<CommandInbox*>(this)->threadOf(plugin);
}

const link::HostSegment* CommandInbox::memoryOf(std::uint16_t plugin) const noexcept {
  const Thread* const thread = threadOf(plugin);
  const bool is_there = thread != nullptr && thread->plan.host < link::kMaxHosts &&
                        thread->plan.thread < link::kMaxThreads && hosts_[thread->plan.host];
  return is_there ? hosts_[thread->plan.host]->segment.get() : nullptr;
}

link::PluginState CommandInbox::stateOf(std::uint16_t plugin) const noexcept {
  const link::HostSegment* const host = plugin < link::kMaxPlugins ? memoryOf(plugin) : nullptr;
  return host == nullptr ? link::PluginState::kAbsent
                         : static_cast<link::PluginState>(host->plugins[plugin].state.load(std::memory_order_relaxed));
}

std::uint64_t CommandInbox::progressOf(std::uint16_t plugin) const noexcept {
  const link::HostSegment* const host = memoryOf(plugin);
  return host == nullptr ? 0 : link::relaxedLoad(host->thread_statistics[threadOf(plugin)->plan.thread].cycles);
}

std::uint64_t CommandInbox::everyOf(std::uint16_t plugin) const noexcept {
  const Thread* const thread = threadOf(plugin);
  return thread == nullptr ? 1 : thread->plan.every;
}

void CommandInbox::want(std::uint16_t plugin) noexcept {
  if (Thread* const thread = threadOf(plugin)) thread->wanted = true;
}

// A thread that answers for other plugins goes on: nothing about it is new.
void CommandInbox::forgive(std::uint16_t plugin) noexcept {
  Thread* const thread = threadOf(plugin);
  if (thread == nullptr || (thread->since != 0 && thread->misses < misses_before_safe_)) return;
  thread->misses = 0;
  thread->since = 0;
  thread->starting = true;
}

link::SlotReader* CommandInbox::readerOf(const Thread& thread) noexcept {
  if (thread.plan.host >= link::kMaxHosts || !hosts_[thread.plan.host] || thread.plan.thread >= link::kMaxThreads)
    return nullptr;
  return &hosts_[thread.plan.host]->readers[thread.plan.thread];
}

// A command that answers a cycle yet to come, or an older one than the last, is none.
bool CommandInbox::take(Thread& thread, std::uint64_t cycle) noexcept {
  link::SlotReader* const reader = readerOf(thread);
  link::CommandData& next = thread.data[1 - thread.current];
  if (reader == nullptr || reader->read(next) != link::Read::kNew) return false;
  if (next.cycle > cycle || next.cycle <= thread.answered) return false;
  thread.answered = next.cycle;
  thread.current = 1 - thread.current;
  thread.heard = true;
  return true;
}

void CommandInbox::await(Thread& thread, std::uint64_t cycle, std::int64_t deadline_ns) noexcept {
  link::SlotReader* const reader = readerOf(thread);
  if (reader == nullptr) return;
  take(thread, cycle);  // what came while another one was waited for
  while (thread.answered != cycle && !waiting_->isOver(deadline_ns)) {
    if (waiting_->await(*reader, deadline_ns)) take(thread, cycle);
  }
}

// From its grant to its first answer a plugin is on its way to its start, through threads that are not in a hurry.
bool CommandInbox::isStarting(Thread& thread, std::uint64_t cycle) const noexcept {
  thread.starting = thread.starting && !thread.heard && cycle - thread.since < start_cycles_;
  return thread.starting;
}

// A slower thread has its whole period: whether it answered is asked when the next one begins, but for the period in
// which it was first asked, since that may have begun before. An answer that comes late is obeyed while it is no older
// than the misses that are allowed.
void CommandInbox::judge(Thread& thread, std::uint64_t cycle) noexcept {
  if (thread.since == 0) thread.since = cycle;
  if (isStarting(thread, cycle)) return;
  const std::uint64_t every = thread.plan.every;
  const std::uint64_t began = cycle - cycle % every;
  const std::uint64_t grace = every == 1 ? 0 : every;
  if (thread.answered + grace >= began) {
    thread.misses = 0;
    return;
  }
  const bool is_asked = cycle == began && cycle >= thread.since + grace;
  if (is_asked) ++missed_;
  if (thread.heard) {
    const std::uint64_t periods = (began - grace - thread.answered + every - 1) / every;
    thread.misses = static_cast<std::uint32_t>(std::min<std::uint64_t>(periods, misses_before_safe_));
  } else if (is_asked && thread.misses < misses_before_safe_) {
    ++thread.misses;
  }
}

void CommandInbox::collect(std::uint64_t cycle, std::int64_t deadline_ns) noexcept {
  for (Thread& thread : threads_) {
    take(thread, cycle);
    if (!thread.wanted) {
      thread.since = 0;
      thread.misses = 0;
      thread.starting = false;
    }
  }
  for (Thread& thread : threads_) {
    if (!thread.wanted) continue;
    if (thread.plan.every == 1) await(thread, cycle, deadline_ns);
    judge(thread, cycle);
  }
}

Answer CommandInbox::answer(std::uint16_t plugin) const noexcept {
  const Thread* const thread = threadOf(plugin);
  if (thread == nullptr || thread->misses >= misses_before_safe_) return Answer::kSafe;
  if (thread->starting || thread->answered == 0) return Answer::kMissed;
  return thread->misses == 0 || thread->heard ? Answer::kFresh : Answer::kMissed;
}

bool CommandInbox::isNew(std::uint16_t plugin) const noexcept {
  const Thread* const thread = threadOf(plugin);
  return thread != nullptr && thread->heard;
}

const link::JointCommand& CommandInbox::command(std::uint16_t plugin, std::uint32_t joint) const noexcept {
  const Thread* const thread = threadOf(plugin);
  return thread->data[thread->current].joints[joint];
}

}  // namespace robotui::rt::hal
