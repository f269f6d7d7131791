// Requests whose answer a host has yet to give.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace robotui::rt::supervisor {

enum class Awaited { kStart, kStop, kReload, kCommand };

class PendingRequests {
 public:
  static constexpr std::size_t kMost = 1024;  // a client that asks without end gets no memory for it
  using Reply = std::function<void(std::uint64_t client, const std::string& text)>;

  explicit PendingRequests(Reply reply) : reply_(std::move(reply)) {}

  void add(Awaited what, std::uint32_t plugin, std::uint64_t client, std::int64_t until_ns, std::uint32_t id = 0);

  // All that wait for this of the plugin (for a command: with this id).
  void settle(Awaited what, std::uint32_t plugin, const std::string& text, std::uint32_t id = 0);
  // All that wait for anything of it.
  void settleAll(std::uint32_t plugin, const std::string& text);
  void expire(std::int64_t now_ns);
  void forget(std::uint64_t client);

 private:
  struct Entry {
    Awaited what;
    std::uint32_t plugin;
    std::uint64_t client;
    std::int64_t until_ns;
    std::uint32_t id;
  };
  template <typename Match>
  void settleIf(const Match& match, const std::string& text);

  Reply reply_;
  std::vector<Entry> entries_;
};

}  // namespace robotui::rt::supervisor
