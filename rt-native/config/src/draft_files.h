// The texts of the files of a draft.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "draft_joints.h"

namespace robotui::rt::config {

struct DraftPlan {
  std::string robot;
  std::string urdf;  // as the configuration names it
  std::string srdf;
  bool floating_base = false;
  bool negative_inertia = false;
  bool has_masses = false;
  std::string posture;
  std::string chain;  // for Cartesian motion; empty where there is none
  std::string swinging;
  std::vector<std::string> packages;  // folders
  std::vector<DraftJoint> joints;
};

using Angles = std::vector<std::pair<std::string, double>>;

std::string jointMapText(const DraftPlan& plan);

// `hardware` is the type of the HAL: dummy or mujoco.
std::string controlText(const DraftPlan& plan, const std::string& hardware);

// For the workbench: it starts `control` first.
std::string workbenchText(const DraftPlan& plan, const std::string& control);

std::string srdfText(const std::string& robot, const std::vector<DraftChain>& chains, const Angles& home);
std::string postureText(const Angles& home);

// A name as YAML has it, in quotes where it needs them.
std::string yamlName(const std::string& name);
std::string numberText(double value);

}  // namespace robotui::rt::config
