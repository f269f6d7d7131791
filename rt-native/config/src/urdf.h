// The links and joints of a URDF as a tree: what is needed to check and to describe a robot. Models read the rest.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotui/rt/config/config.h"

namespace robotui::rt::config {

struct UrdfJoint {
  std::string name;
  std::string type;
  std::string parent;
  std::string child;
  std::string mimics;  // the joint that it follows, or empty
  bool has_limit = false;
  bool has_range = false;
  double lower = 0;
  double upper = 0;
  double velocity = 0;
  double effort = 0;
  double acceleration = 0;  // as all limits: zero where the URDF has none
  double jerk = 0;
  Place place;

  bool moves() const { return type != "fixed"; }
};

// What becomes of moments of inertia below zero, which no body has, but some robots that are published.
enum class NegativeInertia : std::uint8_t { kRefuse, kKeep };

class Urdf {
 public:
  // Throws ConfigError where it is not a tree of links, or a number is none.
  Urdf(const std::filesystem::path& file, const std::string& text, NegativeInertia inertia);

  // What was kept all the same.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

  const std::string& name() const noexcept { return name_; }
  const std::map<std::string, UrdfJoint>& joints() const noexcept { return joints_; }
  bool hasLink(const std::string& link) const { return links_.contains(link); }
  const UrdfJoint* find(const std::string& joint) const;
  const UrdfJoint* above(const std::string& link) const;  // nullptr for the root
  // The joints from `base` down to `tip`; nothing where base does not carry tip.
  std::vector<const UrdfJoint*> path(const std::string& base, const std::string& tip) const;
  std::vector<std::string> jointNames() const;
  std::vector<std::string> linkNames() const;

 private:
  void mustBeTree(const Place& whole) const;

  std::string name_;
  std::vector<std::string> warnings_;
  std::map<std::string, Place> links_;
  std::map<std::string, UrdfJoint> joints_;
  std::map<std::string, std::string> above_;  // link -> joint whose child it is
};

}  // namespace robotui::rt::config
