// A plugin that holds a joint, and does what it is told: whatever a bad plugin can do to its host.
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <stdexcept>
#include <thread>

#include "robotui/rt/plugin/control_plugin.h"

namespace {

using namespace robotui::rt;

class Naughty final : public ControlPlugin {
 public:
  PluginRole role() const noexcept override { return is_observer_ ? PluginRole::kObserver : PluginRole::kControl; }
  bool init_control_plugin(Setup& setup) override {
    const auto at_init = setup.params()["init"].as<std::string>("");
    is_observer_ = setup.params()["observer"].as<bool>(false);
    if (at_init == "claim") setup.claim({"j1"});
    if (at_init == "throw") throw std::runtime_error("it was told to throw");
    if (at_init == "crash") crash();
    if (at_init == "refuse") setup.fail("it was told to refuse");
    for (const auto& name : setup.params()["joints"]) joint_ = setup.robot().findJoint(name.as<std::string>());
    return at_init != "refuse";
  }
  RtStatus on_start(double /*time*/) override {
    held_ = joint_ == nullptr ? 0 : joint_->getJointPosition();
    return todo_ == "refuse" ? RtStatus::failed("it was told to ", todo_) : RtStatus::ok();
  }
  RtStatus control_loop(double /*time*/, double /*period*/) override {
    if (joint_ != nullptr) joint_->setPositionReference(todo_ == "nan" ? std::nan("") : held_);
    misbehave();
    return todo_ == "fail" ? RtStatus::failed("it was told to ", todo_) : RtStatus::ok();
  }
  bool on_command(std::string_view words) override {
    todo_ = words;
    return words != "nonsense";
  }
  std::string_view status() const noexcept override { return todo_.empty() ? "well" : "told"; }

 private:
  // Without the handler of a sanitizer, which would make an exit of it.
  static void crash() {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
  }
  // Everything that its process has mapped writable from the link: its own segments.
  template <typename Spoil>
  static void spoil(const Spoil& each) {
    std::FILE* maps = std::fopen("/proc/self/maps", "r");
    std::array<char, 512> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), maps) != nullptr) {
      unsigned long begin = 0;
      unsigned long end = 0;
      std::array<char, 5> rights{};
      const bool is_map = std::sscanf(line.data(), "%lx-%lx %4s", &begin, &end, rights.data()) == 3;
      if (is_map && rights[1] == 'w' && std::strstr(line.data(), "/memfd:") != nullptr) {
        each(reinterpret_cast<unsigned char*>(begin), end - begin);
      }
    }
    std::fclose(maps);
  }
  static void scribble() {
    spoil([](unsigned char* at, std::size_t size) { std::memset(at, 0xff, size); });
  }
  // Some bytes at places that differ each time.
  void fuzz() {
    spoil([this](unsigned char* at, std::size_t size) {
      for (int i = 0; i < 64; ++i) at[random_() % size] = static_cast<unsigned char>(random_());
    });
  }
  void misbehave() {
    if (todo_ == "crash") crash();
    if (todo_ == "exit") std::_Exit(3);
    if (todo_ == "throw") throw std::runtime_error("it was told to throw");
    if (todo_ == "scribble") scribble();
    if (todo_ == "fuzz") fuzz();
    if (todo_ == "sleep") std::this_thread::sleep_for(std::chrono::milliseconds(5));
    while (todo_ == "spin") spun_ = spun_ + 1;
  }

  bool is_observer_ = false;
  Joint* joint_ = nullptr;
  double held_ = 0;
  std::string todo_;
  std::mt19937 random_{4711};
  volatile std::uint64_t spun_ = 0;
};

}  // namespace

ROBOTUI_RT_PLUGIN(Naughty)
