#include "robotui/rt/supervisor/push_requests.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "quoted.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::supervisor {
namespace {

constexpr const char* kNoHal = "The HAL is not there now: it is being started again.";
constexpr const char* kForm = "push needs JOINT EFFORT SECONDS, or LINK X Y Z SECONDS, not ";

std::vector<double> numbersOf(std::string_view words) {
  std::vector<double> numbers;
  link::forEachWord(words, [&](std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      throw std::invalid_argument(quoted(word) + " is no finite number.");
    numbers.push_back(value);
  });
  return numbers;
}

std::string text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

void checkAmount(double amount, double most, const std::string& what, const std::string& unit) {
  if (amount > most)
    throw std::invalid_argument("A push of " + what + " is at most " + text(most) + " " + unit + ", and not " +
                                text(amount) + ".");
}

}  // namespace

link::Push PushRequests::pushOf(std::string_view words) const {
  const auto [target, rest] = link::splitWord(words);
  std::vector<double> numbers = numbersOf(rest);
  const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                  [&wanted = target](const auto& each) { return each.name == wanted; });
  link::Push push;
  if (joint != robot_.joints.end() && numbers.size() == 2) {
    push.joint = static_cast<std::uint32_t>(joint - robot_.joints.begin());
    const bool slides = joint->type == config::JointType::kPrismatic;
    checkAmount(std::abs(numbers[0]), joint->effort, "the joint " + joint->name, slides ? "N" : "N m");
  } else if (numbers.size() == 4) {
    push.link = target;
    checkAmount(std::hypot(numbers[0], numbers[1], numbers[2]), link::kMostPushingForce, "a link", "N");
  } else {
    throw std::invalid_argument(kForm + quoted(words) + ".");
  }
  push.seconds = numbers.back();
  if (push.seconds <= 0 || push.seconds > link::kLongestPush)
    throw std::invalid_argument("A push is of more than 0 and at most " + text(link::kLongestPush) + " seconds.");
  std::copy(numbers.begin(), numbers.end() - 1, push.force.begin());
  return push;
}

PushRequests::Place* PushRequests::placeFor(std::uint64_t client, std::int64_t now_ns) {
  const auto own =
      std::find_if(places_.begin(), places_.end(), [&](const Place& place) { return place.client == client; });
  if (own != places_.end()) return &*own;
  const auto free = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
    return !place.client || (!place.waits && place.until_ns <= now_ns);
  });
  return free == places_.end() ? nullptr : &*free;
}

void PushRequests::push(std::uint64_t client, std::string_view words, std::int64_t now_ns) {
  link::Push push;
  try {
    push = pushOf(words);
  } catch (const std::invalid_argument& e) {
    replies_.answer(client, e.what());
    return;
  }
  Place* const place = placeFor(client, now_ns);
  if (place == nullptr) {
    replies_.answer(client, std::to_string(places_.size()) + " clients push the robot already.");
  } else if (place->waits) {
    replies_.answer(client, "The push before this one is not answered yet.");
  } else if (push.number = static_cast<std::uint32_t>(place - places_.data());
             !hal_.isOpen() || !hal_.child().socket().send(link::textOf(push))) {
    replies_.answer(client, kNoHal);
  } else {
    *place = {client, push, now_ns + static_cast<std::int64_t>(push.seconds * 1e9), true};
    log_.info("A client pushes the robot: " + std::string(words) + " s.");
  }
}

void PushRequests::answered(std::string_view words) {
  const auto [index, sentence] = link::splitWord(words);
  std::size_t number = places_.size();
  std::from_chars(index.data(), index.data() + index.size(), number);
  if (number >= places_.size() || !places_[number].waits) return;
  Place& place = places_[number];
  place.waits = false;
  if (place.client) replies_.answer(*place.client, std::string(sentence));
  if (!place.client || !sentence.empty()) place = {};
}

void PushRequests::halEnded() {
  for (Place& place : places_) {
    if (place.client && place.waits) replies_.answer(*place.client, kNoHal);
    place = {};
  }
}

// One whose word of the HAL is still awaited keeps its place until then.
void PushRequests::forget(std::uint64_t client) {
  for (Place& place : places_) {
    if (place.client != client) continue;
    place.push.seconds = 0;
    if (hal_.isOpen()) hal_.child().socket().send(link::textOf(place.push));
    place.client.reset();
  }
}

}  // namespace robotui::rt::supervisor
