#include "urdf.h"

#include <algorithm>

#include "robotui/rt/config/reader.h"
#include "xml_file.h"

namespace robotui::rt::config {
namespace {

constexpr std::size_t kMostLinks = 2000;

const std::vector<std::string> kTypes = {"fixed", "revolute", "continuous", "prismatic", "floating", "planar"};

void readLimit(const XmlFile& xml, const Element& element, UrdfJoint& joint) {
  const auto limit = xml.child(element, "limit");
  if (!limit) return;
  joint.has_limit = true;
  joint.has_range = (*limit)->Attribute("lower") != nullptr || (*limit)->Attribute("upper") != nullptr;
  joint.lower = xml.numberOr(**limit, "lower", 0);
  joint.upper = xml.numberOr(**limit, "upper", 0);
  joint.velocity = xml.numberOr(**limit, "velocity", 0);
  joint.effort = xml.numberOr(**limit, "effort", 0);
  joint.acceleration = xml.numberOr(**limit, "acceleration", 0);
  joint.jerk = xml.numberOr(**limit, "jerk", 0);
}

std::string linkOf(const XmlFile& xml, const Element& joint, const char* side) {
  const auto found = xml.child(joint, side);
  if (!found) xml.fail(joint, "has no <" + std::string(side) + " link=\"...\"/>");
  return xml.attribute(**found, "link");
}

UrdfJoint readJoint(const XmlFile& xml, const Element& element) {
  UrdfJoint joint;
  joint.name = xml.attribute(element, "name");
  joint.type = xml.attribute(element, "type");
  joint.place = xml.place(element);
  if (std::find(kTypes.begin(), kTypes.end(), joint.type) == kTypes.end()) {
    xml.fail(element, "has the unknown type '" + joint.type + "'" + didYouMean(joint.type, kTypes));
  }
  joint.parent = linkOf(xml, element, "parent");
  joint.child = linkOf(xml, element, "child");
  if (const auto mimic = xml.child(element, "mimic")) joint.mimics = xml.attribute(**mimic, "joint");
  readLimit(xml, element, joint);
  return joint;
}

void checkMoments(const XmlFile& xml, const Element& link, const Element& inertia, NegativeInertia negative,
                  std::vector<std::string>& warnings) {
  for (const char* moment : {"ixx", "iyy", "izz"}) {
    if (xml.number(inertia, moment) >= 0) continue;
    if (negative == NegativeInertia::kRefuse) {
      xml.fail(link, "has a negative " + std::string(moment) +
                         ", which no body has; mend it, or go on with ModelInterface: {negative_inertia: keep}");
    }
    const ConfigError kept(xml.place(link), "<link> '" + xml.attribute(link, "name") + "' has a negative " + moment +
                                                ", which is kept: models compute with it, and MuJoCo may refuse it");
    warnings.emplace_back(kept.what());
  }
}

void checkInertia(const XmlFile& xml, const Element& link, NegativeInertia negative,
                  std::vector<std::string>& warnings) {
  const auto inertial = xml.child(link, "inertial");
  if (!inertial) return;
  const auto mass = xml.child(**inertial, "mass");
  if (!mass) xml.fail(link, "has an <inertial> without <mass value=\"...\"/>");
  if (xml.number(**mass, "value") < 0) xml.fail(link, "has a negative mass");
  const auto inertia = xml.child(**inertial, "inertia");
  if (!inertia) xml.fail(link, "has an <inertial> without <inertia ixx=\"...\" .../>");
  checkMoments(xml, link, **inertia, negative, warnings);
  for (const char* product : {"ixy", "ixz", "iyz"}) xml.number(**inertia, product);
}

}  // namespace

Urdf::Urdf(const std::filesystem::path& file, const std::string& text, NegativeInertia inertia) {
  const XmlFile xml(file, text);
  name_ = xml.attribute(xml.root(), "name");
  for (const Element* link : xml.children(xml.root(), "link")) {
    if (!links_.emplace(xml.attribute(*link, "name"), xml.place(*link)).second)
      xml.fail(*link, "is there twice; names must be unique");
    checkInertia(xml, *link, inertia, warnings_);
  }
  if (links_.size() > kMostLinks) xml.fail(xml.root(), "has more than " + std::to_string(kMostLinks) + " links");
  for (const Element* element : xml.children(xml.root(), "joint")) {
    UrdfJoint joint = readJoint(xml, *element);
    for (const auto& link : {joint.parent, joint.child}) {
      if (!hasLink(link))
        xml.fail(*element, "joins the link '" + link + "', which is not there" + didYouMean(link, linkNames()));
    }
    if (!above_.emplace(joint.child, joint.name).second) {
      xml.fail(*element, "is the second joint above the link '" + joint.child + "'; a link has one parent");
    }
    if (!joints_.emplace(joint.name, joint).second) xml.fail(*element, "is there twice; names must be unique");
  }
  mustBeTree(xml.place(xml.root()));
}

void Urdf::mustBeTree(const Place& whole) const {
  std::vector<std::string> roots;
  for (const auto& [link, place] : links_) {
    const UrdfJoint* joint = above(link);
    if (joint == nullptr) roots.push_back(link);
    for (std::size_t up = 0; joint != nullptr; ++up, joint = above(joint->parent)) {
      if (up > links_.size()) throw ConfigError(place, "the link '" + link + "' carries itself; links must be a tree");
    }
  }
  if (roots.size() > 1) {
    throw ConfigError(whole, "has several links that nothing carries, such as '" + roots[0] + "' and '" + roots[1] +
                                 "'; join them to one tree");
  }
  if (roots.empty()) throw ConfigError(whole, "has no <link>");
}

const UrdfJoint* Urdf::find(const std::string& joint) const {
  const auto found = joints_.find(joint);
  return found == joints_.end() ? nullptr : &found->second;
}

const UrdfJoint* Urdf::above(const std::string& link) const {
  const auto found = above_.find(link);
  return found == above_.end() ? nullptr : find(found->second);
}

std::vector<const UrdfJoint*> Urdf::path(const std::string& base, const std::string& tip) const {
  std::vector<const UrdfJoint*> joints;
  std::string link = tip;
  while (link != base) {
    const UrdfJoint* joint = above(link);
    if (joint == nullptr) return {};
    joints.push_back(joint);
    link = joint->parent;
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::vector<std::string> Urdf::jointNames() const {
  std::vector<std::string> names;
  for (const auto& [name, joint] : joints_) names.push_back(name);
  return names;
}

std::vector<std::string> Urdf::linkNames() const {
  std::vector<std::string> names;
  for (const auto& [name, place] : links_) names.push_back(name);
  return names;
}

}  // namespace robotui::rt::config
