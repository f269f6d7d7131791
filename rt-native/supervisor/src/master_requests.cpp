#include "robotui/rt/supervisor/master_requests.h"

#include <charconv>

#include "quoted.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {
namespace {

constexpr std::int64_t kComplaintEvery = link::kSecond;
constexpr std::string_view kOwnFramework = "robotui";  // of clients that do not say theirs

}  // namespace

void MasterRequests::take(std::uint64_t client, std::string_view words) {
  const auto [time, named] = link::splitWord(words);
  const std::string_view framework = named.empty() ? kOwnFramework : named;
  double seconds = 0;
  const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), seconds);
  if (!enabled_) {
    replies_.answer(client, "There is no communication handler (--no-ch): references of a master are not taken.");
  } else if (error != std::errc() || end != time.data() + time.size()) {
    replies_.answer(client, "take needs a number of seconds, not " + quoted(words) + ".");
  } else {
    replies_.answer(client, master_.take(client, framework, seconds, link::now()));
  }
}

void MasterRequests::release(std::uint64_t client) { replies_.answer(client, master_.release(client)); }

void MasterRequests::follower(std::uint64_t client) {
  const auto plugin = registry_.masterPlugin();
  if (!plugin) {
    replies_.answer(client, "No plugin here follows references: add XBotCommunicationPlugin to XBotRTPlugins.");
  } else if (registry_.state(*plugin) != link::PluginState::kRunning) {
    const std::string& name = registry_.name(*plugin);
    replies_.answer(client, "Nobody follows references: " + name + " is " +
                                std::string(nameOf(registry_.state(*plugin))) + ". Start it: robotui-rt-ctl switch " +
                                name + " 1.");
  } else {
    replies_.reply(client, "ok " + registry_.name(*plugin));
  }
}

void MasterRequests::reference(std::uint64_t client, std::string_view bytes) {
  const std::int64_t now = link::now();
  const std::string objection = master_.reference(client, bytes, now);
  if (!objection.empty() && now - complained_ns_ > kComplaintEvery) {
    complained_ns_ = now;
    log_.warn(objection);
  }
}

}  // namespace robotui::rt::supervisor
