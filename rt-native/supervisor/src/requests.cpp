#include <algorithm>
#include <charconv>

#include "numbers.h"
#include "robotui/rt/link/clock.h"
#include "robotui/rt/supervisor/supervisor.h"

namespace robotui::rt::supervisor {
namespace {

using link::PluginState;

constexpr std::int64_t kPatience = 2 * link::kSecond;
constexpr std::int64_t kReloadPatience = 65 * link::kSecond;  // a plugin has a minute
constexpr std::int64_t kComplaintEvery = link::kSecond;
constexpr std::size_t kDescriptionPiece = std::size_t{32} * 1024;
constexpr std::string_view kOwnFramework = "robotui";  // of clients that do not say theirs

std::pair<std::string_view, std::string_view> split(std::string_view words) {
  const std::size_t space = words.find(' ');
  return space == std::string_view::npos ? std::pair{words, std::string_view()} : std::pair{words.substr(0, space), words.substr(space + 1)};
}

// What a client wrote, as it can be repeated to it.
std::string quoted(std::string_view words) { return "'" + std::string(words.substr(0, 80)) + "'"; }

}  // namespace

void Supervisor::reply(std::uint64_t client, const std::string& text) {
  board_.publish();  // who reads it after the reply sees what it says
  desk_.reply(client, text);
}

void Supervisor::answer(std::uint64_t client, const std::string& objection) { reply(client, objection.empty() ? "ok" : "error " + objection); }

void Supervisor::changed() {
  board_.publish();
  desk_.broadcast("changed");
}

// What cannot be done for one client (no descriptors are left) ends nothing.
void Supervisor::serve(std::uint64_t client, const link::Packet& packet) {
  try {
    request(client, packet);
  } catch (const std::exception& e) {
    journal_.error(std::string("A request could not be served: ") + e.what());
    answer(client, std::string("This could not be done: ") + e.what());
  }
}

void Supervisor::request(std::uint64_t client, const link::Packet& packet) {
  const std::string_view verb = packet.verb();
  const std::string_view rest = packet.rest();
  if (verb == "reference") {
    reference(client, rest);
    return;
  }
  journal_.detail("client " + std::to_string(client) + " asks: " + packet.text.substr(0, 200));
  if (verb == "attach") {
    attach(client);
  } else if (verb == "switch") {
    switchPlugin(client, rest);
  } else if (verb == "reload") {
    reload(client, rest);
  } else if (verb == "command") {
    command(client, rest);
  } else if (verb == "status") {
    status(client, rest);
  } else if (verb == "take") {
    take(client, rest);
  } else if (verb == "release") {
    answer(client, master_.release(client));
  } else if (verb == "describe") {
    describe(client, rest);
  } else {
    answer(client, "The request " + quoted(verb) + " is not known. There are: attach, switch, reload, command, status, take, release, describe, reference.");
  }
}

// A text of the robot in pieces, as packets are small: "describe urdf OFFSET" is answered by "ok NEXT PIECE", where NEXT is 0 at the end.
void Supervisor::describe(std::uint64_t client, std::string_view words) {
  const auto [which, from] = split(words);
  std::size_t offset = 0;
  const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), offset);
  if ((which != "urdf" && which != "srdf") || error != std::errc() || end != from.data() + from.size()) {
    answer(client, "describe needs urdf or srdf and an offset, not " + quoted(words) + ".");
    return;
  }
  const std::string& text = which == "urdf" ? config_.robot.urdf : config_.robot.srdf;
  offset = std::min(offset, text.size());
  std::size_t stop = std::min(offset + kDescriptionPiece, text.size());
  while (stop < text.size() && stop > offset && (static_cast<unsigned char>(text[stop]) & 0xC0U) == 0x80U) --stop;  // characters stay whole
  desk_.reply(client, "ok " + std::to_string(stop < text.size() ? stop : 0) + " " + text.substr(offset, stop - offset));
}

void Supervisor::attach(std::uint64_t client) {
  if (!hal_.isOpen()) {
    answer(client, "The HAL is not there now: it is being started again.");
    return;
  }
  std::vector<link::Descriptor> shared;
  shared.push_back(hal_.state().shareReadOnly());
  shared.push_back(board_.share());
  for (const auto& host : hosts_) {
    shared.push_back(host->segment().shareReadOnly());
  }
  const std::vector<int> given = numbersOf(shared);
  board_.publish();
  desk_.reply(client, "attached " + std::to_string(hosts_.size()), given);
}

void Supervisor::switchPlugin(std::uint64_t client, std::string_view words) {
  const auto [name, wanted] = split(words);
  const auto plugin = roster_.find(name);
  if (!plugin) {
    answer(client, roster_.unknown(name));
  } else if (wanted != "1" && wanted != "0") {
    answer(client, "switch needs 1 or 0 behind the plugin, not " + quoted(wanted) + ".");
  } else if (wanted == "1") {
    start(client, *plugin);
  } else {
    stop(client, *plugin);
  }
}

void Supervisor::start(std::uint64_t client, std::uint32_t plugin) {
  if (roster_.state(plugin) == PluginState::kRunning) {
    answer(client, {});
    return;
  }
  if (roster_.state(plugin) != PluginState::kStarting) {
    const std::string objection = roster_.objection(plugin);
    if (!objection.empty()) {
      answer(client, objection);
      return;
    }
    roster_.starting(plugin);
    board_.publish();
    hosts_[roster_.host(plugin)]->child().socket().send("start " + roster_.name(plugin));
  }
  pending_.add(Awaited::kStart, plugin, client, link::now() + kPatience);
}

void Supervisor::stop(std::uint64_t client, std::uint32_t plugin) {
  if (!roster_.isActive(plugin)) {
    answer(client, {});
    return;
  }
  if (roster_.state(plugin) != PluginState::kStopping) {
    roster_.stopping(plugin);
    hosts_[roster_.host(plugin)]->child().socket().send("stop " + roster_.name(plugin));
  }
  pending_.add(Awaited::kStop, plugin, client, link::now() + kPatience);
}

void Supervisor::reload(std::uint64_t client, std::string_view words) {
  const auto plugin = roster_.find(words);
  if (!plugin) {
    answer(client, roster_.unknown(words));
    return;
  }
  if (roster_.isActive(*plugin) && !roster_.isIo(*plugin)) {
    answer(client, roster_.name(*plugin) + " runs: stop it before it is reloaded.");
    return;
  }
  HostKeeper& host = *hosts_[roster_.host(*plugin)];
  pending_.add(Awaited::kReload, *plugin, client, link::now() + kReloadPatience);
  if (host.child().isAlive()) {
    host.child().socket().send("reload " + roster_.name(*plugin));
  } else {
    host.forgive();  // it is started in the next turn, or when the HAL is there again
  }
}

void Supervisor::command(std::uint64_t client, std::string_view words) {
  const auto [name, order] = split(words);
  const auto plugin = roster_.find(name);
  if (!plugin) {
    answer(client, roster_.unknown(name));
    return;
  }
  HostKeeper& host = *hosts_[roster_.host(*plugin)];
  const PluginState state = roster_.state(*plugin);
  if (!host.child().isAlive() || state == PluginState::kAbsent || state == PluginState::kFailed) {
    answer(client, roster_.name(*plugin) + " is not there to be told something: it is " + roster_.describe(*plugin) + ".");
    return;
  }
  const std::uint32_t id = next_command_++;
  pending_.add(Awaited::kCommand, *plugin, client, link::now() + kPatience, id);
  host.child().socket().send("command " + std::to_string(id) + " " + roster_.name(*plugin) + " " + std::string(order));
}

void Supervisor::status(std::uint64_t client, std::string_view words) {
  const auto plugin = roster_.find(words);
  reply(client, plugin ? "ok " + roster_.describe(*plugin) : "error " + roster_.unknown(words));
}

void Supervisor::take(std::uint64_t client, std::string_view words) {
  const auto [time, named] = split(words);
  const std::string_view framework = named.empty() ? kOwnFramework : named;
  double seconds = 0;
  const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), seconds);
  if (!options_.communication.enabled) {
    answer(client, "There is no communication handler (--no-ch): references of a master are not taken.");
  } else if (error != std::errc() || end != time.data() + time.size()) {
    answer(client, "take needs a number of seconds, not " + quoted(words) + ".");
  } else {
    answer(client, master_.take(client, framework, seconds, link::now()));
  }
}

// Has no reply; what is wrong with it goes to the log, once a second.
void Supervisor::reference(std::uint64_t client, std::string_view text) {
  const std::int64_t now = link::now();
  const std::string objection = master_.reference(client, text, now);
  if (!objection.empty() && now - reference_complaint_ns_ > kComplaintEvery) {
    reference_complaint_ns_ = now;
    journal_.warn(objection);
  }
}

}  // namespace robotui::rt::supervisor
