// What the plugin threads command, and whether they do it in time.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "robotui/rt/link/command.h"
#include "robotui/rt/link/segment.h"

namespace robotui::rt::hal {

struct ThreadPlan {
  std::uint32_t host;
  std::uint32_t thread;  // in the host
  std::uint64_t every;   // cycles of the HAL; it is due in those that are multiples
};

struct CommandPlan {
  std::vector<ThreadPlan> threads;
  std::vector<std::uint32_t> thread_of_plugin;  // by the plugin's index on the board
  std::uint64_t start_cycles = 1000;            // of the HAL, that a plugin has from its grant to its first answer
};

enum class Answer : std::uint8_t {
  kFresh,   // of this cycle, of this period of a slower thread, or one that came late within the budget of misses
  kMissed,  // hold
  kSafe     // missed too often in turn
};

// The time in which an answer is waited for: another one in tests, where it passes only when they say so.
class Waiting {
 public:
  virtual ~Waiting() = default;
  virtual bool isOver(std::int64_t deadline_ns) const noexcept;
  // Sleeps until the slot has news, at most until the deadline; true where it has.
  virtual bool await(const link::SlotReader& slot, std::int64_t deadline_ns) noexcept;
};

// link/PROTOCOL.md says when an answer counts.
class CommandInbox {
 public:
  using HostView = link::Segment<const link::HostSegment>;

  // `waiting` outlives it.
  CommandInbox(CommandPlan plan, std::uint32_t joints, std::uint32_t misses_before_safe, Waiting& waiting);
  ~CommandInbox();
  CommandInbox(const CommandInbox&) = delete;
  CommandInbox& operator=(const CommandInbox&) = delete;

  // On an ordinary thread: the memory of a host, from the next cycle on in place of what it had before.
  void offer(std::uint32_t host, HostView segment);

  // The rest on the real-time thread, in this order each cycle.
  void begin() noexcept;
  void want(std::uint16_t plugin) noexcept;     // its commands count in this cycle
  void forgive(std::uint16_t plugin) noexcept;  // it was started anew
  void collect(std::uint64_t cycle, std::int64_t deadline_ns) noexcept;
  Answer answer(std::uint16_t plugin) const noexcept;
  bool isNew(std::uint16_t plugin) const noexcept;  // its answer came in this cycle
  const link::JointCommand& command(std::uint16_t plugin, std::uint32_t joint) const noexcept;

  // What the host of a plugin writes in its memory, on the real-time thread: its state as the host sees it, how many
  // cycles its thread has done, and how many of the HAL each of these takes.
  link::PluginState stateOf(std::uint16_t plugin) const noexcept;
  std::uint64_t progressOf(std::uint16_t plugin) const noexcept;
  std::uint64_t everyOf(std::uint16_t plugin) const noexcept;

  std::uint64_t missed() const noexcept { return missed_; }

 private:
  struct Host;
  struct Thread {
    ThreadPlan plan{};
    std::array<link::CommandData, 2> data{};  // the last command that counts, and room for the next
    std::size_t current = 0;
    std::uint64_t answered = 0;  // newest cycle that a command answered
    std::uint64_t since = 0;     // the first cycle in which its commands counted, without a break
    std::uint32_t misses = 0;    // periods in turn for which no answer came in time
    bool wanted = false;
    bool heard = false;     // an answer came in this cycle
    bool starting = false;  // granted, and not heard since
  };

  Thread* threadOf(std::uint16_t plugin) noexcept;
  const Thread* threadOf(std::uint16_t plugin) const noexcept;
  const link::HostSegment* memoryOf(std::uint16_t plugin) const noexcept;
  link::SlotReader* readerOf(const Thread& thread) noexcept;
  void adopt(std::size_t host) noexcept;
  bool take(Thread& thread, std::uint64_t cycle) noexcept;
  void await(Thread& thread, std::uint64_t cycle, std::int64_t deadline_ns) noexcept;
  bool isStarting(Thread& thread, std::uint64_t cycle) const noexcept;
  void judge(Thread& thread, std::uint64_t cycle) noexcept;

  Waiting* waiting_;
  std::uint32_t joints_;
  std::uint32_t misses_before_safe_;
  std::uint64_t start_cycles_;
  std::vector<Thread> threads_;
  std::vector<std::uint32_t> thread_of_plugin_;
  std::array<std::unique_ptr<Host>, link::kMaxHosts> hosts_;
  std::array<std::atomic<Host*>, link::kMaxHosts> offered_{};
  std::array<std::atomic<Host*>, link::kMaxHosts> retired_{};  // to be freed by the ordinary thread
  std::uint64_t missed_ = 0;
};

}  // namespace robotui::rt::hal
