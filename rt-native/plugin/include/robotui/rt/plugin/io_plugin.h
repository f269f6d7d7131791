// What an IO plugin is: derive from IoPlugin, end the file with ROBOTUI_RT_IO_PLUGIN(Class), build it as lib<Class>.so.
#pragma once

#include <cstdint>
#include <string_view>

#include "robotui/rt/plugin/control_plugin.h"

namespace robotui::rt {

// Runs in the communication handler, a process of its own without real time: it may block, but all IO plugins take
// turns, so a long wait delays the others. It exchanges data with control plugins by channels (setup.channels()) and
// commands no joints.
class IoPlugin {
 public:
  virtual ~IoPlugin() = default;

  // May throw (its message is shown). False where it cannot work, after setup.fail(why).
  virtual bool init(Setup& setup) = 0;

  // Every period of the communication handler (--ch-period), with the newest state of the robot sensed. May throw: then
  // it fails.
  virtual void run(double time, double period) = 0;

  // A word from the user (<PLUGIN>_cmd), between two runs; false where it is not understood.
  virtual bool on_command(std::string_view /*words*/) { return false; }

  // One line for the user (<PLUGIN>_status); views memory of the plugin.
  virtual std::string_view status() const noexcept { return {}; }

  virtual void close() {}
};

}  // namespace robotui::rt

#define ROBOTUI_RT_IO_PLUGIN(Class)                                                                        \
  ROBOTUI_RT_PLUGIN_ABI                                                                                    \
  extern "C" __attribute__((visibility("default"))) robotui::rt::IoPlugin* robotui_rt_io_plugin_create() { \
    return new Class();                                                                                    \
  }
