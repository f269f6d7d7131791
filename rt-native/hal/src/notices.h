// What is told to the user: each condition once, until it is over.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace robotui::rt::hal {

// From all ordinary threads; never from the one of real time.
class Notices {
 public:
  // The condition holds from now on. One that comes and goes is told at most once in ten seconds.
  void raise(const std::string& condition, const std::string& sentence, std::int64_t now_ns);

  // It is over: `sentence` is told where the condition was, nothing where it is empty.
  void clear(const std::string& condition, const std::string& sentence);

  // Something that happened, with the same bound.
  void tell(const std::string& event, const std::string& sentence, std::int64_t now_ns);

  std::vector<std::string> take();

 private:
  struct State {
    std::int64_t told_ns = 0;  // 0 is never
    bool holds = false;
    bool told = false;
  };
  bool isDue(const State& state, std::int64_t now_ns) const noexcept;
  void add(const std::string& sentence);

  std::mutex mutex_;
  std::map<std::string, State> states_;
  std::vector<std::string> sentences_;
};

}  // namespace robotui::rt::hal
