#include "srdf.h"

#include <algorithm>
#include <map>
#include <set>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/layout.h"
#include "xml_file.h"

namespace robotui::rt::config {
namespace {

const std::set<std::string> kSpecial = {"chains", "imu_sensors", "force_torque_sensors"};

class Groups {
 public:
  Groups(const XmlFile& xml, const Urdf& urdf, RobotDescription& robot, std::vector<std::string>& warnings)
      : xml_(xml), urdf_(urdf), robot_(robot), warnings_(warnings) {
    for (const auto& joint : robot.joints) commanded_.insert(joint.name);
    for (const Element* joint : xml.children(xml.root(), "virtual_joint"))
      virtual_.insert(xml.attribute(*joint, "name"));
    for (const Element* group : xml.children(xml.root(), "group")) {
      if (!groups_.emplace(xml.attribute(*group, "name"), group).second)
        xml.fail(*group, "is there twice; names must be unique");
    }
  }

  void read() {
    warnOfPassiveJoints();
    readChains();
    readImus();
    readForceTorques();
    for (const Element* state : xml_.children(xml_.root(), "group_state"))
      robot_.postures.push_back(readPosture(*state));
    for (const Element* pair : xml_.children(xml_.root(), "disable_collisions"))
      robot_.free_to_touch.emplace_back(xml_.attribute(*pair, "link1"), xml_.attribute(*pair, "link2"));
  }

 private:
  // One that nothing drives.
  void warnOfPassiveJoints() {
    for (const Element* joint : xml_.children(xml_.root(), "passive_joint")) {
      if (commanded_.contains(xml_.attribute(*joint, "name")))
        warn(*joint, "is a passive_joint, and all the same in the joint map: it is commanded");
    }
  }

  // With a group `chains` its subgroups are meant, in that order; else every group that is a chain by itself.
  void readChains() {
    const auto list = groups_.find("chains");
    if (list == groups_.end()) {
      for (const Element* group : xml_.children(xml_.root(), "group")) addChain(*group, false);
      return;
    }
    for (const Element* member : xml_.children(*list->second, "group")) {
      const std::string name = xml_.attribute(*member, "name");
      const auto group = groups_.find(name);
      if (group == groups_.end())
        xml_.fail(*member, "is in the group 'chains', but there is no group of that name" + didYouMean(name, names()));
      addChain(*group->second, true);
    }
  }

  void addChain(const Element& group, bool asked) {
    const std::string name = xml_.attribute(group, "name");
    if (kSpecial.contains(name)) return;
    ChainDescription chain{name, {}, {}, {}};
    const auto path = pathOf(group, chain, asked);
    for (const UrdfJoint* joint : path) {
      if (commanded_.contains(joint->name)) chain.joints.push_back(joint->name);
    }
    if (!chain.joints.empty())
      robot_.chains.push_back(chain);
    else if (asked)
      warn(group, "has no joint of the joint map and is no chain");
  }

  std::vector<const UrdfJoint*> pathOf(const Element& group, ChainDescription& chain, bool asked) {
    if (const auto ends = xml_.child(group, "chain")) {
      chain.base_link = xml_.attribute(**ends, "base_link");
      chain.tip_link = xml_.attribute(**ends, "tip_link");
      if (!hasLink(group, chain.base_link) || !hasLink(group, chain.tip_link)) return {};
      auto path = urdf_.path(chain.base_link, chain.tip_link);
      if (path.empty())
        warn(group, "goes from '" + chain.base_link + "' to '" + chain.tip_link +
                        "', but the first does not carry the second: it is left out");
      return path;
    }
    return pathOfMembers(group, chain, asked);
  }

  std::vector<const UrdfJoint*> pathOfMembers(const Element& group, ChainDescription& chain, bool asked) {
    const auto members = membersOf(group);
    if (members.empty()) return {};
    const auto deepest =
        *std::max_element(members.begin(), members.end(), [this](auto* a, auto* b) { return depth(*a) < depth(*b); });
    const auto highest =
        *std::min_element(members.begin(), members.end(), [this](auto* a, auto* b) { return depth(*a) < depth(*b); });
    chain.base_link = highest->parent;
    chain.tip_link = deepest->child;
    const auto path = urdf_.path(chain.base_link, chain.tip_link);
    const bool one_path = std::all_of(members.begin(), members.end(),
                                      [&](auto* m) { return std::find(path.begin(), path.end(), m) != path.end(); });
    if (!one_path && asked)
      xml_.fail(group,
                "is in the group 'chains', but its joints do not lie one behind the other; write <chain "
                "base_link=\"...\" tip_link=\"...\"/>");
    return one_path ? inOrder(path, members) : std::vector<const UrdfJoint*>{};
  }

  static std::vector<const UrdfJoint*> inOrder(std::vector<const UrdfJoint*> path,
                                               const std::vector<const UrdfJoint*>& members) {
    std::erase_if(path, [&](auto* joint) { return std::find(members.begin(), members.end(), joint) == members.end(); });
    return path;
  }

  std::vector<const UrdfJoint*> membersOf(const Element& group) {
    std::vector<const UrdfJoint*> members;
    for (const Element* element : xml_.children(group, "joint")) {
      if (const UrdfJoint* joint = jointOf(*element)) members.push_back(joint);
    }
    for (const Element* element : xml_.children(group, "link")) {
      const std::string name = xml_.attribute(*element, "name");
      const UrdfJoint* above = hasLink(*element, name) ? urdf_.above(name) : nullptr;
      if (above != nullptr) members.push_back(above);
    }
    return members;
  }

  void readImus() {
    const auto group = groups_.find("imu_sensors");
    if (group == groups_.end()) return;
    for (const Element* element : xml_.children(*group->second, "link")) {
      const std::string name = xml_.attribute(*element, "name");
      if (hasLink(*element, name)) robot_.imus.push_back({name, name});
    }
    for (const Element* element : xml_.children(*group->second, "joint")) {
      if (const UrdfJoint* joint = jointOf(*element)) robot_.imus.push_back({joint->child, joint->child});
    }
    if (robot_.imus.size() > link::kMaxImus)
      xml_.fail(*group->second, "has more than " + std::to_string(link::kMaxImus) + " sensors");
  }

  void readForceTorques() {
    const auto group = groups_.find("force_torque_sensors");
    if (group == groups_.end()) return;
    for (const Element* element : xml_.children(*group->second, "joint")) {
      if (const UrdfJoint* joint = jointOf(*element)) robot_.force_torques.push_back({joint->name, joint->child});
    }
    for (const Element* element : xml_.children(*group->second, "link")) {
      const std::string name = xml_.attribute(*element, "name");
      if (hasLink(*element, name)) robot_.force_torques.push_back({name, name});
    }
    if (robot_.force_torques.size() > link::kMaxForceTorques) {
      xml_.fail(*group->second, "has more than " + std::to_string(link::kMaxForceTorques) + " sensors");
    }
  }

  Posture readPosture(const Element& state) {
    Posture posture{xml_.attribute(state, "name"), xml_.attribute(state, "group"), {}};
    for (const Element* element : xml_.children(state, "joint")) {
      const UrdfJoint* there = jointOf(*element);
      if (there == nullptr) continue;
      const std::string& name = there->name;
      const double value = xml_.number(*element, "value");
      const auto joint =
          std::find_if(robot_.joints.begin(), robot_.joints.end(), [&](const auto& j) { return j.name == name; });
      if (joint == robot_.joints.end()) continue;  // a gripper that others move, a fixed joint
      if (value < joint->lower || value > joint->upper) {
        warn(*element, "is beyond the limits of the joint in the posture '" + posture.name + "'");
      }
      posture.joints.emplace_back(name, std::clamp(value, joint->lower, joint->upper));
    }
    return posture;
  }

  // SRDFs are shared by variants of a robot: what this one lacks is left out. MoveIt has virtual joints in its groups.
  const UrdfJoint* jointOf(const Element& element) {
    const std::string name = xml_.attribute(element, "name");
    const UrdfJoint* joint = urdf_.find(name);
    if (joint == nullptr && !virtual_.contains(name))
      warn(element, "is not in the URDF: it is left out" + didYouMean(name, urdf_.jointNames()));
    return joint;
  }

  bool hasLink(const Element& element, const std::string& name) {
    if (urdf_.hasLink(name)) return true;
    warn(element, "names the link '" + name + "', which is not in the URDF: it is left out" +
                      didYouMean(name, urdf_.linkNames()));
    return false;
  }

  std::size_t depth(const UrdfJoint& joint) const {
    std::size_t steps = 0;
    for (const UrdfJoint* up = &joint; up != nullptr; up = urdf_.above(up->parent)) ++steps;
    return steps;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& [name, group] : groups_) result.push_back(name);
    return result;
  }

  void warn(const Element& element, const std::string& what) {
    const char* name = element.Attribute("name");
    const ConfigError line(xml_.place(element), "'" + std::string(name == nullptr ? "" : name) + "' " + what);
    warnings_.emplace_back(line.what());
  }

  const XmlFile& xml_;
  const Urdf& urdf_;
  RobotDescription& robot_;
  std::vector<std::string>& warnings_;
  std::set<std::string> commanded_;
  std::set<std::string> virtual_;  // names of joints between the robot and the world
  std::map<std::string, const Element*> groups_;
};

}  // namespace

void readSrdf(const std::filesystem::path& file, const std::string& text, const Urdf& urdf, RobotDescription& robot,
              std::vector<std::string>& warnings) {
  const XmlFile xml(file, text);
  Groups(xml, urdf, robot, warnings).read();
}

}  // namespace robotui::rt::config
