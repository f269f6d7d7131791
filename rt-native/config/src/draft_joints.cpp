#include "draft_joints.h"

#include <algorithm>
#include <map>

#include "robotui/rt/link/layout.h"

namespace robotui::rt::config {
namespace {

// Where the URDF has none: so slow and weak that nothing breaks while somebody looks for the real ones.
constexpr double kTurning = 1.0;       // rad/s
constexpr double kSliding = 0.1;       // m/s
constexpr double kTorque = 10;         // N m
constexpr double kForce = 100;         // N
constexpr double kToFullSpeed = 0.1;   // s from rest to the velocity limit
constexpr double kToFullForce = 0.05;  // s from no acceleration to its limit

double orElse(double limit, double chosen) { return limit > 0 ? limit : chosen; }

DraftJoint limited(const UrdfJoint& joint) {
  const bool slides = joint.type == "prismatic";
  const double velocity = orElse(joint.velocity, slides ? kSliding : kTurning);
  const double acceleration = orElse(joint.acceleration, velocity / kToFullSpeed);
  return {&joint, velocity, orElse(joint.effort, slides ? kForce : kTorque), acceleration,
          orElse(joint.jerk, acceleration / kToFullForce)};
}

// Why it cannot be commanded; empty where it can.
std::string objectionTo(const UrdfJoint& joint) {
  if (!joint.mimics.empty()) return "follows '" + joint.mimics + "'";
  if (joint.type == "floating" || joint.type == "planar") return "is " + joint.type;
  if (joint.type != "continuous" && !(joint.lower < joint.upper))
    return "has no range: write <limit lower=\"...\" upper=\"...\"/>, or type=\"continuous\" where it has no end";
  if (joint.name.size() >= link::kNameLength) return "has a name that is longer than 63 bytes";
  return {};
}

class Walk {
 public:
  explicit Walk(const Urdf& urdf) {
    for (const auto& [name, joint] : urdf.joints()) below_[joint.parent].push_back(&joint);
    for (auto& [link, joints] : below_) {
      std::sort(joints.begin(), joints.end(), [](auto* a, auto* b) { return a->place.line < b->place.line; });
    }
  }

  DraftJoints from(const std::string& root) {
    visit(root, {"", root, root, 0});
    return std::move(found_);
  }

 private:
  // A chain ends at a link with several branches that move, and where nothing more moves. URDFs are trees of 2000 links
  // at most.
  void visit(const std::string& link, DraftChain chain) {  // NOLINT(misc-no-recursion)
    const auto joints = below_.find(link);
    const auto branches = joints == below_.end() ? 0
                                                 : std::count_if(joints->second.begin(), joints->second.end(),
                                                                 [&](auto* joint) { return moves(*joint); });
    if (branches != 1) {
      end(chain);
      chain = {"", link, link, 0};
    }
    if (joints == below_.end()) return;
    for (const UrdfJoint* joint : joints->second) {
      DraftChain on = moves(*joint) ? chain : DraftChain{"", joint->child, joint->child, 0};
      on.tip_link = joint->child;
      on.joints += take(*joint) ? 1U : 0U;
      visit(joint->child, on);
    }
  }

  // Whether something that can be commanded lies there or behind it.
  bool moves(const UrdfJoint& joint) {  // NOLINT(misc-no-recursion)
    const auto known = moves_.find(&joint);
    if (known != moves_.end()) return known->second;
    bool any = joint.moves() && objectionTo(joint).empty();
    if (const auto joints = below_.find(joint.child); !any && joints != below_.end())
      any = std::any_of(joints->second.begin(), joints->second.end(), [&](auto* each) { return moves(*each); });
    return moves_[&joint] = any;
  }

  bool take(const UrdfJoint& joint) {
    if (!joint.moves()) return false;
    std::string why = objectionTo(joint);
    if (why.empty() && found_.joints.size() == link::kMaxJoints)
      why = "is one more than the " + std::to_string(link::kMaxJoints) + " that there is room for";
    if (why.empty())
      found_.joints.push_back(limited(joint));
    else
      found_.left_out.push_back("the joint '" + joint.name + "', which " + why + " (line " +
                                std::to_string(joint.place.line) + ")");
    return why.empty();
  }

  void end(const DraftChain& chain) {
    if (chain.joints < 2) return;
    found_.chains.push_back(chain);
    found_.chains.back().name = chain.tip_link;
  }

  std::map<std::string, std::vector<const UrdfJoint*>> below_;
  std::map<const UrdfJoint*, bool> moves_;
  DraftJoints found_;
};

}  // namespace

DraftJoints draftJoints(const Urdf& urdf) {
  std::string root;
  for (const std::string& link : urdf.linkNames()) {
    if (urdf.above(link) == nullptr) root = link;
  }
  return Walk(urdf).from(root);
}

}  // namespace robotui::rt::config
