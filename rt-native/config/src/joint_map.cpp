#include "joint_map.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/layout.h"

namespace robotui::rt::config {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

int idOf(const std::string& key, const Reader& value) {
  int id = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), id);
  if (error != std::errc{} || end != key.data() + key.size() || id < 0 || id > 65535) {
    value.fail("has an id that is no whole number from 0 to 65535; write `1: name_of_a_joint`");
  }
  return id;
}

void mustBeCommandable(const UrdfJoint& joint, const Reader& value) {
  const std::string where = joint.place.file.string() + ":" + std::to_string(joint.place.line);
  const std::string the = "is '" + joint.name + "', ";
  if (joint.type == "fixed")
    value.fail(the + "which is fixed in the URDF (" + where + "): it cannot be moved; take it out of the map");
  if (joint.type == "floating" || joint.type == "planar") {
    value.fail(the + "which is " + joint.type + " in the URDF (" + where +
               "); expected revolute, continuous or prismatic");
  }
  if (!joint.mimics.empty()) {
    value.fail(the + "which follows '" + joint.mimics + "' in the URDF (" + where + "); take it out of the map");
  }
}

void mustHaveLimits(const UrdfJoint& joint) {
  const std::string the = "the joint '" + joint.name + "' ";
  if (joint.velocity <= 0 || joint.effort <= 0) {
    throw ConfigError(
        joint.place,
        the +
            "is in the joint map but has no limits of velocity and effort above zero; write <limit lower=\"-1\" "
            "upper=\"1\" velocity=\"2\" effort=\"50\"/>, or JointLimits: {" +
            joint.name + ": {velocity: 2, effort: 50}} in the configuration");
  }
  if (joint.type != "continuous" && (!joint.has_range || joint.lower >= joint.upper)) {
    throw ConfigError(joint.place, the +
                                       "has no range: its lower limit must be below its upper one; write <limit "
                                       "lower=\"-1\" upper=\"1\" .../>, or "
                                       "type=\"continuous\" where it has no end");
  }
}

JointDescription describeJoint(int id, const UrdfJoint& joint) {
  const bool endless = joint.type == "continuous";
  return {id,
          joint.name,
          joint.type == "prismatic" ? JointType::kPrismatic : JointType::kRevolute,
          endless ? -kInfinite : joint.lower,
          endless ? kInfinite : joint.upper,
          joint.velocity,
          joint.effort,
          joint.acceleration > 0 ? joint.acceleration : kInfinite,
          joint.jerk > 0 ? joint.jerk : kInfinite};
}

void mustBeNew(const std::vector<JointDescription>& joints, int id, const std::string& name, const Reader& value) {
  for (const auto& joint : joints) {
    if (joint.id == id)
      value.fail("has the id " + std::to_string(id) + ", which '" + joint.name + "' has already; ids must be unique");
    if (joint.name == name)
      value.fail("is '" + name + "', which has the id " + std::to_string(joint.id) + " already; remove one of them");
  }
}

}  // namespace

std::vector<JointDescription> readJointMap(const std::filesystem::path& file, const Place& wanted, const Urdf& urdf,
                                           const JointLimits& limits) {
  const Reader top = readYamlFile(file, wanted, "the joint map");
  std::vector<JointDescription> joints;
  for (const auto& [key, value] : top.at("joint_map", "joint_map: {1: name_of_a_joint, 2: ...}").entries()) {
    const int id = idOf(key, value);
    const std::string name = value.text();
    const UrdfJoint* joint = urdf.find(name);
    if (joint == nullptr) {
      value.fail("is '" + name + "', but the URDF has no joint of that name" + didYouMean(name, urdf.jointNames()));
    }
    mustBeCommandable(*joint, value);
    mustBeNew(joints, id, name, value);
    const UrdfJoint limited = limits.appliedTo(*joint);
    mustHaveLimits(limited);
    if (name.size() >= link::kNameLength) value.fail("is '" + name + "', which is longer than 63 bytes");
    joints.push_back(describeJoint(id, limited));
  }
  if (joints.empty()) top.fail("joint_map is empty; write joint_map: {1: name_of_a_joint, 2: ...}");
  if (joints.size() > link::kMaxJoints)
    top.fail("joint_map has more than " + std::to_string(link::kMaxJoints) + " joints");
  limits.mustName(joints);
  std::sort(joints.begin(), joints.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return joints;
}

}  // namespace robotui::rt::config
