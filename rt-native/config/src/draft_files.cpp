#include "draft_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace robotui::rt::config {
namespace {

constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
constexpr std::string_view kPlainBehind = "0123456789-./";
constexpr std::array<std::string_view, 9> kWords{"y", "n", "yes", "no", "true", "false", "on", "off", "null"};

bool isPlain(const std::string& name) {
  const bool is_path = name.starts_with("/") || name.starts_with("../");
  if (name.empty() || (!is_path && kPlain.find(name.front()) == std::string_view::npos)) return false;
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  if (std::find(kWords.begin(), kWords.end(), lower) != kWords.end()) return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return kPlain.find(c) != std::string_view::npos || kPlainBehind.find(c) != std::string_view::npos;
  });
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string limitsText(const DraftPlan& plan) {
  std::ostringstream text;
  text << "# Rests on the URDF, which these limits may make narrower. What the URDF has not was chosen, and is for you "
          "to mend.\n"
          "JointLimits:\n";
  for (const DraftJoint& each : plan.joints) {
    std::string entries;
    const auto add = [&](bool is_chosen, const char* key, double value) {
      if (is_chosen) entries += (entries.empty() ? "" : ", ") + std::string(key) + ": " + numberText(value);
    };
    add(each.velocityIsChosen(), "velocity", each.velocity);
    add(each.effortIsChosen(), "effort", each.effort);
    add(each.accelerationIsChosen(), "acceleration", each.acceleration);
    add(each.jerkIsChosen(), "jerk", each.jerk);
    text << "  " << yamlName(each.joint->name) << ": {" << entries << "}\n";
  }
  return text.str() + "\n";
}

std::string pluginsText(const DraftPlan& plan) {
  std::ostringstream text;
  text << "xbotcore_threads:\n"
          "  rt_main: {sched: fifo, prio: 60, period: 0.001}\n"
          "  rt_slow: {sched: fifo, prio: 40, period: 0.004, host: models}\n\n"
          "xbotcore_plugins:\n"
          "  Homing:\n    thread: rt_main\n    type: Homing\n    params: {posture: "
       << yamlName(plan.posture)
       << "}\n"
          "  Sine:\n    thread: rt_main\n    type: Sine\n    params: {joints: ["
       << yamlName(plan.swinging)
       << "]}\n"
          "  JointTrajectory:\n    thread: rt_main\n    type: JointTrajectory\n  XBotCommunicationPlugin:\n    thread: "
          "rt_main\n    type: XBotCommunicationPlugin\n";
  if (!plan.chain.empty())
    text << "  CartesianMotion:\n    thread: rt_slow\n    type: CartesianMotion\n    params: {chain: "
         << yamlName(plan.chain) << "}\n";
  if (plan.has_masses)
    text << "  JointImpedance:\n    thread: rt_slow\n    type: JointImpedance\n    params: {gravity: true}\n"
            "  GravityCompensation:\n    thread: rt_slow\n    type: GravityCompensation\n";
  return text.str();
}

}  // namespace

std::string numberText(double value) {
  std::array<char, 64> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end};
}

std::string yamlName(const std::string& name) {
  if (isPlain(name)) return name;
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::string jointMapText(const DraftPlan& plan) {
  std::ostringstream text;
  text << "# id of the joint on the bus: its name in the URDF. The ids are a first choice, in the order of the "
          "URDF.\njoint_map:\n";
  int id = 0;
  for (const DraftJoint& each : plan.joints) text << "  " << ++id << ": " << yamlName(each.joint->name) << '\n';
  return text.str();
}

std::string controlText(const DraftPlan& plan, const std::string& hardware) {
  const bool simulates = hardware == "mujoco";
  std::ostringstream text;
  text << "# "
       << (simulates ? "Simulated with forces and contacts by MuJoCo."
                     : "Hardware that moves as it is told, without forces.")
       << " docs/rt-configuration.md names every key.\nXBotInterface:\n  urdf_path: " << yamlName(plan.urdf)
       << "\n  srdf_path: " << yamlName(plan.srdf)
       << "\n  joint_map_path: joint_map.yaml\n\nModelInterface:\n  model_type: KDL\n"
       << "  is_model_floating_base: " << (plan.floating_base ? "true" : "false") << '\n'
       << (plan.negative_inertia ? "  negative_inertia: keep\n" : "")
       << "\nMasterCommunicationInterface:\n  framework_name: robotui         # or ROS\n\nHALInterface:\n  type: "
       << hardware << '\n';
  if (simulates)
    text << "  params:\n    ignore_meshes: true           # they touch nothing\n"
         << (plan.floating_base ? "    fix_base: true                # hangs: these plugins do not balance\n" : "");
  text << "  misses_before_safe: 20          # a simulation on an ordinary kernel; hardware keeps the default of 2\n\n"
       << limitsText(plan) << pluginsText(plan);
  return text.str();
}

std::string workbenchText(const DraftPlan& plan, const std::string& control) {
  const std::string robot = yamlName(plan.robot);
  std::string folders;
  for (const std::string& folder : plan.packages) folders += (folders.empty() ? "" : ", ") + yamlName(folder);
  return "# The workbench for this robot: ./robotui run starts its real-time control first, and ends it at the end.\n"
         "control: " +
         control + "\n\nruics:\n  " + robot +
         ":\n    type: manipulator\n    rfics:\n      rt: {type: xbot}\n    uics:\n      scene3d:\n        displays:\n"
         "          - {type: grid}\n"
         "          - {type: robotmodel, settings: {packages: [" +
         folders +
         "]}}    # where package://... is looked for\n"
         "    safety:\n      " +
         robot + ":\n        stop_call: {interface: rt, service: stop_plugins}\n";
}

std::string postureText(const Angles& home) {
  std::string text = "  <group_state group=\"all\" name=\"home\">\n";
  for (const auto& [name, value] : home)
    text += "    <joint name=\"" + escaped(name) + "\" value=\"" + numberText(value) + "\"/>\n";
  return text + "  </group_state>\n";
}

std::string srdfText(const std::string& robot, const std::vector<DraftChain>& chains, const Angles& home) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + escaped(robot) + "\">\n";
  std::string members;
  for (const DraftChain& chain : chains) {
    text += "  <group name=\"" + escaped(chain.name) + "\"><chain base_link=\"" + escaped(chain.base_link) +
            "\" tip_link=\"" + escaped(chain.tip_link) + "\"/></group>\n";
    members += "<group name=\"" + escaped(chain.name) + "\"/>";
  }
  return text + "  <group name=\"chains\">" + members + "</group>\n" + postureText(home) + "</robot>\n";
}

}  // namespace robotui::rt::config
