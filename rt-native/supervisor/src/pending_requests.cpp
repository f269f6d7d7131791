#include "robotui/rt/supervisor/pending_requests.h"

#include <algorithm>

namespace robotui::rt::supervisor {

void PendingRequests::add(Awaited what, std::uint32_t plugin, std::uint64_t client, std::int64_t until_ns,
                          std::uint32_t id) {
  if (entries_.size() >= kMost) {
    reply_(client, "error Too many requests wait for an answer.");
    return;
  }
  entries_.push_back({what, plugin, client, until_ns, id});
}

template <typename Match>
void PendingRequests::settleIf(const Match& match, const std::string& text) {
  const auto rest =
      std::stable_partition(entries_.begin(), entries_.end(), [&](const Entry& entry) { return !match(entry); });
  const std::vector<Entry> settled(rest, entries_.end());
  entries_.erase(rest, entries_.end());
  for (const Entry& entry : settled) {
    reply_(entry.client, text);
  }
}

void PendingRequests::settle(Awaited what, std::uint32_t plugin, const std::string& text, std::uint32_t id) {
  settleIf([&](const Entry& entry) { return entry.what == what && entry.plugin == plugin && entry.id == id; }, text);
}

void PendingRequests::settleAll(std::uint32_t plugin, const std::string& text) {
  settleIf([&](const Entry& entry) { return entry.plugin == plugin; }, text);
}

void PendingRequests::expire(std::int64_t now_ns) {
  settleIf([&](const Entry& entry) { return entry.until_ns <= now_ns; },
           "error The host of the plugin did not answer in time.");
}

void PendingRequests::forget(std::uint64_t client) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.client == client; });
}

}  // namespace robotui::rt::supervisor
