#include "robotui/rt/config/draft.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

#include "draft_files.h"
#include "draft_packages.h"
#include "srdf.h"
#include "text_file.h"
#include "xml_file.h"

namespace robotui::rt::config {
namespace {

constexpr std::size_t kShown = 4;  // names in a sentence

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kShown ? text + " and " + std::to_string(names.size() - kShown) + " more" : text;
}

// A file near the folder moves with it; others are where they are.
std::string pathFrom(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const auto relative = std::filesystem::absolute(file).lexically_relative(folder);
  const auto ups = std::count(relative.begin(), relative.end(), std::filesystem::path(".."));
  return ups <= 2 && !relative.empty() ? relative.string()
                                       : std::filesystem::absolute(file).lexically_normal().string();
}

std::vector<std::string> namesWhere(const std::vector<DraftJoint>& joints, bool (DraftJoint::*is_so)() const) {
  std::vector<std::string> names;
  for (const DraftJoint& each : joints) {
    if ((each.*is_so)()) names.push_back(each.joint->name);
  }
  return names;
}

class Drafting {
 public:
  Drafting(const std::filesystem::path& urdf, const std::filesystem::path& srdf, std::filesystem::path folder)
      : urdf_file_(std::filesystem::absolute(urdf).lexically_normal()),
        urdf_text_(readTextFile(urdf_file_, {}, "the URDF", kLargestXml)),
        urdf_(urdf_file_, urdf_text_, NegativeInertia::kKeep), found_(draftJoints(urdf_)), folder_(std::move(folder)) {
    if (!srdf.empty()) srdf_file_ = std::filesystem::absolute(srdf).lexically_normal();
    mustHaveJoints();
    plan_.robot = urdf_.name();
    plan_.joints = found_.joints;
    plan_.urdf = pathFrom(folder_, urdf_file_);
    plan_.negative_inertia = !urdf_.warnings().empty();
    plan_.has_masses = urdf_text_.find("<inertial") != std::string::npos;
    findPackages();
    plan_.swinging = found_.joints.front().joint->name;
    plan_.floating_base = std::any_of(urdf_.joints().begin(), urdf_.joints().end(),
                                      [](const auto& each) { return each.second.type == "floating"; });
    for (const DraftJoint& each : plan_.joints) {
      robot_.joints.push_back({0, each.joint->name, JointType::kRevolute, lowerOf(*each.joint), upperOf(*each.joint),
                               each.velocity, each.effort});
    }
  }

  Draft draft() {
    if (srdf_file_.empty())
      writeSrdf();
    else
      takeSrdf();
    sayJoints();
    sayLimits();
    Draft result{plan_.robot, plan_.posture, {}, std::move(chosen_), std::move(found_.left_out)};
    result.files.push_back({"joint_map.yaml", jointMapText(plan_)});
    if (!srdf_text_.empty()) result.files.push_back({srdfName(), srdf_text_});
    result.files.push_back({"rt-dummy.yaml", controlText(plan_, "dummy")});
    result.files.push_back({"rt-mujoco.yaml", controlText(plan_, "mujoco")});
    result.files.push_back({"robot.yaml", workbenchText(plan_, "rt-dummy.yaml")});
    return result;
  }

 private:
  static constexpr double kEndless = 3.0;  // rad, of a joint that has no end: only to choose a posture

  static double lowerOf(const UrdfJoint& joint) { return joint.type == "continuous" ? -kEndless : joint.lower; }
  static double upperOf(const UrdfJoint& joint) { return joint.type == "continuous" ? kEndless : joint.upper; }

  void mustHaveJoints() const {
    if (!found_.joints.empty()) return;
    std::string why = "has no joint that can be commanded: expected one that is revolute, continuous or prismatic";
    if (!found_.left_out.empty()) why += "; left out would be " + listed(found_.left_out);
    throw ConfigError({urdf_file_, 0, 0}, why);
  }

  void findPackages() {
    DraftPackages packages = draftPackages(urdf_file_, urdf_text_);
    plan_.packages = std::move(packages.folders);
    for (const std::string& name : packages.not_found)
      found_.left_out.push_back(
          "the meshes of the package '" + name +
          "', which is not in a folder above the URDF: add its folder to `packages` in robot.yaml");
  }

  static std::string srdfName() { return "robot.srdf"; }

  Angles homeAngles() const {
    Angles home;
    for (const JointDescription& joint : robot_.joints) {
      const bool zero_is_within = joint.lower <= 0 && 0 <= joint.upper;
      home.emplace_back(joint.name, zero_is_within ? 0.0 : (joint.lower + joint.upper) / 2);
    }
    return home;
  }

  void writeSrdf() {
    srdf_text_ = srdfText(plan_.robot, found_.chains, homeAngles());
    plan_.srdf = srdfName();
    plan_.posture = "home";
    std::vector<std::string> names;
    for (const DraftChain& chain : found_.chains) names.push_back("'" + chain.name + "'");
    chosen_.push_back(
        "There is no SRDF: " + srdfName() + " has " +
        (names.empty() ? "no groups" : "the groups " + listed(names) + ", each of the joints between two branches") +
        ", and a posture 'home' with every joint at zero, or in the middle of its range where that excludes zero.");
    if (plan_.floating_base) chosen_.push_back("The base is free, since the URDF has a floating joint.");
    chooseChain(found_.chains);
  }

  void takeSrdf() {
    const std::string text = readTextFile(srdf_file_, {}, "the SRDF", kLargestXml);
    std::vector<std::string> warnings;
    readSrdf(srdf_file_, text, urdf_, robot_, warnings);
    const XmlFile xml(srdf_file_, text);
    for (const Element* joint : xml.children(xml.root(), "virtual_joint")) {
      const char* type = joint->Attribute("type");
      plan_.floating_base = plan_.floating_base || (type != nullptr && std::string_view(type) == "floating");
    }
    chosen_.push_back(plan_.floating_base ? "The base is free, since URDF or SRDF has a floating joint."
                                          : "The base is fixed, since neither URDF nor SRDF has a floating joint.");
    for (const std::string& warning : warnings) found_.left_out.push_back("of the SRDF: " + warning);
    choosePosture(text);
    std::vector<DraftChain> chains;
    for (const ChainDescription& chain : robot_.chains)
      chains.push_back({chain.name, chain.base_link, chain.tip_link, chain.joints.size()});
    chooseChain(chains);
  }

  // `home`, else the one with most joints, else one of our own in a copy of the file.
  void choosePosture(const std::string& text) {
    const Posture* best = nullptr;
    for (const Posture& each : robot_.postures) {
      const bool is_better = best == nullptr || (best->name != "home" &&
                                                 (each.name == "home" || each.joints.size() > best->joints.size()));
      if (!each.joints.empty() && is_better) best = &each;
    }
    if (best != nullptr) {
      plan_.srdf = pathFrom(folder_, srdf_file_);
      plan_.posture = best->name;
      sayPosture(*best);
      return;
    }
    const auto end = text.rfind("</robot>");
    if (end == std::string::npos)
      throw ConfigError({srdf_file_, 0, 0},
                        "has no </robot> at its end; write its groups between <robot> and </robot>");
    srdf_text_ = text.substr(0, end) + postureText(homeAngles()) + text.substr(end);
    plan_.srdf = srdfName();
    plan_.posture = "home";
    chosen_.push_back("The SRDF has no posture of these joints: " + srdfName() + " is a copy with a posture 'home'.");
  }

  void sayPosture(const Posture& posture) {
    std::set<std::string> there;
    for (const auto& [name, value] : posture.joints) there.insert(name);
    std::vector<std::string> others;
    for (const DraftJoint& each : plan_.joints) {
      if (!there.contains(each.joint->name)) others.push_back(each.joint->name);
    }
    chosen_.push_back(
        "Homing goes to the posture '" + posture.name + "' of the SRDF" +
        (others.empty() ? "." : ", which says nothing of " + listed(others) + ": they stay where they are."));
  }

  void chooseChain(const std::vector<DraftChain>& chains) {
    const auto longest =
        std::max_element(chains.begin(), chains.end(), [](auto& a, auto& b) { return a.joints < b.joints; });
    if (longest != chains.end() && longest->joints > 1) {
      plan_.chain = longest->name;
      chosen_.push_back("CartesianMotion moves '" + longest->name + "', from " + longest->base_link + " to " +
                        longest->tip_link + ".");
    } else {
      found_.left_out.push_back("the plugin CartesianMotion, as no group is a chain of two joints or more");
    }
    if (!plan_.has_masses)
      found_.left_out.push_back("the plugins JointImpedance and GravityCompensation, as no link has an <inertial>");
  }

  void sayJoints() {
    std::vector<std::string> names;
    for (const DraftJoint& each : plan_.joints) names.push_back(each.joint->name);
    chosen_.insert(chosen_.begin(),
                   std::to_string(names.size()) + " joints are commanded (" + listed(names) +
                       "), with ids from 1 in the order of the URDF: write those of your bus into joint_map.yaml.");
    if (plan_.negative_inertia)
      chosen_.push_back(
          "negative_inertia is 'keep', since a link has a moment of inertia below zero: mend the URDF where it can "
          "be.");
  }

  void sayLimits() {
    sayChosen(&DraftJoint::velocityIsChosen, "velocity", "1 rad/s or 0.1 m/s");
    sayChosen(&DraftJoint::effortIsChosen, "effort", "10 N m or 100 N");
    sayChosen(&DraftJoint::accelerationIsChosen, "acceleration", "the velocity limit in 0.1 s");
    sayChosen(&DraftJoint::jerkIsChosen, "jerk", "the acceleration limit in 0.05 s");
  }

  void sayChosen(bool (DraftJoint::*is_chosen)() const, const std::string& what, const std::string& value) {
    const auto names = namesWhere(plan_.joints, is_chosen);
    if (names.empty()) return;
    chosen_.push_back("The URDF has no limit of " + what + " for " +
                      (names.size() == plan_.joints.size() ? "any of them" : listed(names)) + ": chosen is " + value +
                      " (JointLimits).");
  }

  std::filesystem::path urdf_file_;
  std::string urdf_text_;
  Urdf urdf_;
  DraftJoints found_;
  std::filesystem::path folder_;
  std::filesystem::path srdf_file_;
  std::string srdf_text_;  // of the file that is written, where one is
  DraftPlan plan_;
  RobotDescription robot_{};
  std::vector<std::string> chosen_;
};

}  // namespace

Draft draftOf(const std::filesystem::path& urdf, const std::filesystem::path& srdf,
              const std::filesystem::path& folder) {
  return Drafting(urdf, srdf, std::filesystem::absolute(folder).lexically_normal()).draft();
}

void writeDraft(const Draft& draft, const std::filesystem::path& folder) {
  for (const DraftFile& file : draft.files) {
    if (std::filesystem::exists(folder / file.name))
      throw ConfigError({folder / file.name, 0, 0}, "is there already; choose another folder, or move it away");
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw ConfigError({folder, 0, 0}, "cannot be made: " + error.message() + "; choose another folder");
  for (const DraftFile& file : draft.files) {
    std::ofstream out(folder / file.name);
    out << file.text << std::flush;
    if (!out)
      throw ConfigError({folder / file.name, 0, 0},
                        std::string("cannot be written: ") + std::strerror(errno) + "; choose another folder");
  }
}

}  // namespace robotui::rt::config
