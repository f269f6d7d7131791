#include "notices.h"

#include <utility>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal {

namespace {

constexpr std::int64_t kPause = 10 * link::kSecond;  // between two sentences of one condition
constexpr std::size_t kMostWaiting = 32;

}  // namespace

bool Notices::isDue(const State& state, std::int64_t now_ns) const noexcept {
  return state.told_ns == 0 || now_ns - state.told_ns >= kPause;
}

void Notices::add(const std::string& sentence) {
  if (!sentence.empty() && sentences_.size() < kMostWaiting) sentences_.push_back(sentence);
}

void Notices::raise(const std::string& condition, const std::string& sentence, std::int64_t now_ns) {
  const std::lock_guard lock(mutex_);
  State& state = states_[condition];
  if (state.holds) return;
  state.holds = true;
  state.told = isDue(state, now_ns);
  if (!state.told) return;
  state.told_ns = now_ns;
  add(sentence);
}

void Notices::clear(const std::string& condition, const std::string& sentence) {
  const std::lock_guard lock(mutex_);
  const auto found = states_.find(condition);
  if (found == states_.end() || !found->second.holds) return;
  found->second.holds = false;
  if (found->second.told) add(sentence);
}

void Notices::tell(const std::string& event, const std::string& sentence, std::int64_t now_ns) {
  const std::lock_guard lock(mutex_);
  State& state = states_[event];
  if (!isDue(state, now_ns)) return;
  state.told_ns = now_ns;
  add(sentence);
}

std::vector<std::string> Notices::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(sentences_, {});
}

}  // namespace robotui::rt::hal
