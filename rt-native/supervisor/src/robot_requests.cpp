#include "robotui/rt/supervisor/robot_requests.h"

#include <algorithm>
#include <charconv>

#include "numbers.h"
#include "quoted.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {
namespace {

constexpr const char* kNoHal = "The HAL is not there now: it is being started again.";
constexpr std::size_t kDescriptionPiece = std::size_t{32} * 1024;

}  // namespace

void RobotRequests::attach(std::uint64_t client) {
  if (!hal_.isOpen()) {
    replies_.answer(client, kNoHal);
    return;
  }
  std::vector<link::Descriptor> shared;
  shared.push_back(hal_.state().shareReadOnly());
  shared.push_back(board_.share());
  for (link::Descriptor& segment : hosts_.shareSegments()) {
    shared.push_back(std::move(segment));
  }
  replies_.reply(client, "attached " + std::to_string(hosts_.size()), numbersOf(shared));
}

void RobotRequests::askHal(std::uint64_t client, std::string_view what) {
  const bool asked = hal_.isOpen() && hal_.child().socket().send(std::string(what));
  replies_.answer(client, asked ? "" : kNoHal);
}

// A plugin that runs and has joints; empty where none does.
std::string RobotRequests::leader() {
  const link::BoardData& board = board_.data();
  for (std::uint32_t joint = 0; joint < board.joints; ++joint) {
    const std::uint16_t owner = board_.owner(joint);
    if (owner < board.plugins && board.plugin[owner].state == static_cast<std::uint32_t>(link::PluginState::kRunning))
      return std::string(link::view(board.plugin[owner].name));
  }
  return {};
}

void RobotRequests::disable(std::uint64_t client) {
  if (const std::string plugin = leader(); !plugin.empty())
    replies_.answer(client, plugin + " leads joints: stop it before the drives are disabled.");
  else
    askHal(client, "disable");
}

void RobotRequests::drives(std::uint64_t client) {
  if (hal_.isOpen())
    replies_.reply(client, "ok " + hal_.drives());
  else
    replies_.answer(client, kNoHal);
}

void RobotRequests::stops(std::uint64_t client) {
  if (hal_.isOpen())
    replies_.reply(client, "ok " + stops_.lines());
  else
    replies_.answer(client, kNoHal);
}

void RobotRequests::press(std::uint64_t client, std::string_view words) {
  const auto [wanted, name] = link::splitWord(words);
  if (wanted != "1" && wanted != "0") {
    replies_.answer(client, "press needs 1 or 0 before the emergency stop, not " + quoted(wanted) + ".");
  } else if (!hal_.isOpen()) {
    replies_.answer(client, kNoHal);
  } else if (const std::string objection = stops_.objectionToPress(name); !objection.empty()) {
    replies_.answer(client, objection);
  } else {
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      if (name.empty() || stops_.name(i) == name)
        hal_.child().socket().send("press " + std::to_string(i) + " " + std::string(wanted));
    }
    replies_.answer(client, {});
  }
}

void RobotRequests::describe(std::uint64_t client, std::string_view words) {
  const auto [which, from] = link::splitWord(words);
  std::size_t offset = 0;
  const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), offset);
  if ((which != "urdf" && which != "srdf") || error != std::errc() || end != from.data() + from.size()) {
    replies_.answer(client, "describe needs urdf or srdf and an offset, not " + quoted(words) + ".");
    return;
  }
  const std::string& text = which == "urdf" ? robot_.urdf : robot_.srdf;
  offset = std::min(offset, text.size());
  std::size_t stop = std::min(offset + kDescriptionPiece, text.size());
  while (stop < text.size() && stop > offset && (static_cast<unsigned char>(text[stop]) & 0xC0U) == 0x80U)
    --stop;  // characters stay whole
  replies_.reply(client,
                 "ok " + std::to_string(stop < text.size() ? stop : 0) + " " + text.substr(offset, stop - offset));
}

}  // namespace robotui::rt::supervisor
