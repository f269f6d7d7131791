#include "robotui/rt/link/trajectory_orders.h"

#include <array>
#include <charconv>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::link {
namespace {

constexpr std::size_t kLongestOrder = 490;   // bytes: a plugin takes 496
constexpr std::size_t kLongestPhrase = 400;  // of one verb
constexpr int kDigits = 12;                  // that count, of a number

std::string text(double number) {
  std::array<char, 32> room{};
  const auto [end, error] =
      std::to_chars(room.data(), room.data() + room.size(), number, std::chars_format::general, kDigits);
  return {room.data(), end};
}

}  // namespace

// The clock of the machine tells clients apart, and one that was started anew from what it was before.
TrajectoryOrders::TrajectoryOrders() : tag_(static_cast<std::uint64_t>(now())) { add("begin"); }

void TrajectoryOrders::values(std::string_view kind, std::span<const double> numbers) {
  std::vector<std::string> words;
  words.reserve(numbers.size());
  for (const double number : numbers) words.push_back(text(number));
  say(kind, words);
}

void TrajectoryOrders::say(std::string_view verb, double number, std::string_view joint) {
  std::string phrase(verb);
  phrase.append(" ").append(text(number));
  if (!joint.empty()) phrase.append(" ").append(joint);
  add(phrase);
}

std::vector<std::string> TrajectoryOrders::take() {
  add("run");
  orders_.push_back(std::move(order_));
  return std::move(orders_);
}

std::string TrajectoryOrders::stop() const { return "@" + std::to_string(tag_) + " stop"; }

// As many phrases of that verb as the words need.
void TrajectoryOrders::say(std::string_view verb, std::span<const std::string> words) {
  std::string phrase;
  for (const std::string& word : words) {
    if (!phrase.empty() && phrase.size() + word.size() >= kLongestPhrase) {
      add(phrase);
      phrase.clear();
    }
    if (phrase.empty()) phrase = verb;
    phrase += " " + word;
  }
  if (!phrase.empty()) add(phrase);
}

void TrajectoryOrders::add(const std::string& phrase) {
  if (!order_.empty() && order_.size() + phrase.size() < kLongestOrder) {
    order_ += ";" + phrase;
    return;
  }
  if (!order_.empty()) orders_.push_back(std::move(order_));
  order_ = "@" + std::to_string(tag_) + " " + phrase;
}

}  // namespace robotui::rt::link
