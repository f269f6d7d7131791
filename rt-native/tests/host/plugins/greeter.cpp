// An IO plugin that counts its runs into a channel.
#include <cstdint>

#include "robotui/rt/plugin/io_plugin.h"

namespace {

using namespace robotui::rt;

class Greeter final : public IoPlugin {
 public:
  bool init(Setup& setup) override {
    runs_ = ChannelWriter<std::uint64_t>(setup.channels(), "greeter.runs");
    return true;
  }
  void run(double /*time*/, double /*period*/) override {
    if (crash_) __builtin_trap();
    runs_.write(++count_);
  }
  bool on_command(std::string_view words) override {
    crash_ = words == "crash";
    return true;
  }
  std::string_view status() const noexcept override { return count_ > 0 ? "running" : "new"; }

 private:
  ChannelWriter<std::uint64_t> runs_;
  std::uint64_t count_ = 0;
  bool crash_ = false;
};

}  // namespace

ROBOTUI_RT_IO_PLUGIN(Greeter)
