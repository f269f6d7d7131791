// What a control plugin is: derive from ControlPlugin, end the file with ROBOTUI_RT_PLUGIN(Class), build it as
// lib<Class>.so.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "robotui/rt/link/plugin_role.h"
#include "robotui/rt/plugin/abi.h"
#include "robotui/rt/plugin/channel.h"
#include "robotui/rt/plugin/rt_log.h"
#include "robotui/rt/plugin/rt_status.h"
#include "robotui/rt/robot/model_interface.h"
#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt {

using link::PluginRole;

// What a plugin is given when it is made ready. Not to be used in the control loop.
class Setup {
 public:
  virtual ~Setup() = default;
  virtual const std::string& name() const = 0;   // of this plugin in the configuration
  virtual const YAML::Node& params() const = 0;  // `params` of the configuration; may be an empty map
  virtual double period() const = 0;             // of its thread, seconds
  virtual RobotInterface& robot() = 0;           // lives as long as the plugin
  virtual RtLog& log() = 0;                      // lives as long as the plugin
  virtual ChannelDirectory& channels() = 0;      // to other plugins of the robot; lives as long as the plugin
  virtual std::unique_ptr<ModelInterface> createModel() = 0;  // of `model_type`
  virtual const link::MasterSegment& master() = 0;  // what the master framework wants: for a communication plugin
  // The joints it will command, by name; `joints:` or `chains:` in its parameters are claimed before by themselves, and
  // a plugin without both and without a claim commands none. A joint has one owner: a start is refused while another
  // plugin that owns one runs.
  virtual void claim(const std::vector<std::string>& joints) = 0;
  // Why init failed, for the user.
  virtual void fail(const std::string& why) = 0;
};

// Life: made, init_control_plugin, then any number of times on_start, control_loop every period, on_stop; then close,
// unloaded.
class ControlPlugin {
 public:
  virtual ~ControlPlugin() = default;

  // What it is there for; asked once it has been made ready. An observer may claim no joints.
  virtual PluginRole role() const noexcept { return PluginRole::kControl; }

  // Not real time: may block, allocate, throw (its message is shown). False where it cannot work, after
  // setup.fail(why).
  virtual bool init_control_plugin(Setup& setup) = 0;

  // All three in the real-time thread of the plugin. Times are seconds of the control's clock. The host calls
  // robot.sense() before and robot.move() after; they must not allocate, block or throw. Where on_start or control_loop
  // returns that it failed, the plugin is stopped, its joints become safe, and the text is shown; it can be reloaded.
  // One that throws all the same is treated alike, but what it throws costs memory of the heap, and so time.
  virtual RtStatus on_start(double /*time*/) { return RtStatus::ok(); }
  virtual RtStatus control_loop(double time, double period) = 0;
  virtual void on_stop(double /*time*/) {}

  // A word from the user (<PLUGIN>_cmd), in the real-time thread between two loops; false where it is not understood.
  virtual bool on_command(std::string_view /*words*/) { return false; }

  // One line for the user (<PLUGIN>_status), copied after each loop where it changed; views memory of the plugin.
  virtual std::string_view status() const noexcept { return {}; }

  // Not real time.
  virtual void close() {}
};

}  // namespace robotui::rt

// What every library of a plugin exports, whatever kind it is.
#define ROBOTUI_RT_PLUGIN_ABI                                                                                     \
  extern "C" __attribute__((visibility("default"))) std::uint32_t robotui_rt_plugin_abi() {                       \
    return robotui::rt::kPluginAbi;                                                                               \
  }                                                                                                               \
  extern "C" __attribute__((visibility("default"))) const robotui::rt::link::AbiFact* robotui_rt_plugin_facts() { \
    return robotui::rt::kPluginFacts;                                                                             \
  }

#define ROBOTUI_RT_PLUGIN(Class)                                                                             \
  ROBOTUI_RT_PLUGIN_ABI                                                                                      \
  extern "C" __attribute__((visibility("default"))) robotui::rt::ControlPlugin* robotui_rt_plugin_create() { \
    return new Class();                                                                                      \
  }
