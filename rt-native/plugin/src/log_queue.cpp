#include "robotui/rt/plugin/log_queue.h"

#include <algorithm>
#include <cstring>

namespace robotui::rt {

std::string_view nameOf(LogLevel level) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"info", "warn", "error"};
  return kNames[static_cast<std::size_t>(level)];
}

LogQueue::LogQueue() : cells_(std::make_unique<std::array<Cell, kLines>>()) {
  for (std::size_t i = 0; i < kLines; ++i) {
    (*cells_)[i].turn.store(i, std::memory_order_relaxed);
  }
}

// Each cell counts its turns: a writer takes the cell whose turn is its ticket, the reader the one whose turn is one
// further.
bool LogQueue::push(LogLevel level, std::uint32_t source, std::string_view text) noexcept {
  std::uint64_t ticket = head_.load(std::memory_order_relaxed);
  Cell* cell = nullptr;
  for (;;) {
    cell = &(*cells_)[ticket % kLines];
    const std::uint64_t turn = cell->turn.load(std::memory_order_acquire);
    if (turn < ticket) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    if (turn == ticket && head_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_relaxed)) {
      break;
    }
    if (turn != ticket) {
      ticket = head_.load(std::memory_order_relaxed);
    }
  }
  cell->line.level = level;
  cell->line.source = source;
  cell->line.length = static_cast<std::uint16_t>(std::min(text.size(), kLineLength));
  std::memcpy(cell->line.text.data(), text.data(), cell->line.length);
  cell->turn.store(ticket + 1, std::memory_order_release);
  return true;
}

bool LogQueue::pop(Line& line) noexcept {
  Cell& cell = (*cells_)[tail_ % kLines];
  if (cell.turn.load(std::memory_order_acquire) != tail_ + 1) {
    return false;
  }
  line = cell.line;
  cell.turn.store(tail_ + kLines, std::memory_order_release);
  ++tail_;
  return true;
}

std::uint64_t LogQueue::takeLost() noexcept { return lost_.exchange(0, std::memory_order_relaxed); }

}  // namespace robotui::rt
