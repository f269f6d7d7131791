// The queue between threads that log and the one that writes the lines down.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "robotui/rt/plugin/rt_log.h"

namespace robotui::rt {

enum class LogLevel : std::uint8_t { kInfo, kWarn, kError };

std::string_view nameOf(LogLevel level) noexcept;

// Bounded, lock-free, any number of writers, one reader.
class LogQueue {
 public:
  static constexpr std::size_t kLines = 256;
  static constexpr std::size_t kLineLength = 240;

  struct Line {
    LogLevel level;
    std::uint32_t source;  // as given to TaggedLog
    std::uint16_t length;
    std::array<char, kLineLength> text;
    std::string_view view() const noexcept { return {text.data(), length}; }
  };

  LogQueue();

  bool push(LogLevel level, std::uint32_t source, std::string_view text) noexcept;  // false: full, and counted
  bool pop(Line& line) noexcept;
  std::uint64_t takeLost() noexcept;  // lines that found no room since the last call

 private:
  struct Cell {
    std::atomic<std::uint64_t> turn;
    Line line;
  };
  std::unique_ptr<std::array<Cell, kLines>> cells_;
  std::atomic<std::uint64_t> head_{0};
  std::atomic<std::uint64_t> lost_{0};
  std::uint64_t tail_ = 0;
};

// The log of one plugin: `source` tells whose lines they are.
class TaggedLog final : public RtLog {
 public:
  TaggedLog(LogQueue& queue, std::uint32_t source) : queue_(queue), source_(source) {}
  void info(std::string_view line) noexcept override { queue_.push(LogLevel::kInfo, source_, line); }
  void warn(std::string_view line) noexcept override { queue_.push(LogLevel::kWarn, source_, line); }
  void error(std::string_view line) noexcept override { queue_.push(LogLevel::kError, source_, line); }

 private:
  LogQueue& queue_;
  std::uint32_t source_;
};

}  // namespace robotui::rt
