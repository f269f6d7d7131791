#include "joint_limits.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace robotui::rt::config {
namespace {

constexpr std::string_view kAll = "default";
constexpr double kLeast = 1e-6;
constexpr double kMost = 1e9;

struct Quantity {
  const char* key;
  double UrdfJoint::*limit;
};

constexpr std::array<Quantity, 4> kQuantities{{{"velocity", &UrdfJoint::velocity},
                                               {"effort", &UrdfJoint::effort},
                                               {"acceleration", &UrdfJoint::acceleration},
                                               {"jerk", &UrdfJoint::jerk}}};

void mustBeLimits(const Reader& entry) {
  entry.knowsOnly({"velocity", "effort", "acceleration", "jerk"});
  for (const Quantity& quantity : kQuantities) {
    if (const auto value = entry.find(quantity.key)) value->real(kLeast, kMost);
  }
}

// Who wants more than the URDF allows has to say so there: it is what the hardware bears.
void mustBeNarrower(const Reader& value, double limit, const UrdfJoint& joint, double of_urdf) {
  if (of_urdf <= 0 || limit <= of_urdf) return;
  std::ostringstream text;
  text << "is " << limit << ", wider than the " << of_urdf << " of the URDF (" << joint.place.file.string() << ':'
       << joint.place.line << "); write at most that, or mend the URDF";
  value.fail(text.str());
}

}  // namespace

JointLimits::JointLimits(const Reader& block) {
  for (const auto& [name, entry] : block.entries()) {
    mustBeLimits(entry);
    if (name == kAll)
      all_ = entry;
    else
      joints_.emplace(name, entry);
  }
}

UrdfJoint JointLimits::appliedTo(UrdfJoint joint) const {
  const auto own = joints_.find(joint.name);
  for (const Quantity& quantity : kQuantities) {
    double& limit = joint.*quantity.limit;
    const auto of_joint = own == joints_.end() ? std::nullopt : own->second.find(quantity.key);
    const auto of_all = all_ ? all_->find(quantity.key) : std::nullopt;
    if (of_joint) {
      const double wanted = of_joint->real(kLeast, kMost);
      mustBeNarrower(*of_joint, wanted, joint, limit);
      limit = wanted;
    } else if (of_all) {
      const double wanted = of_all->real(kLeast, kMost);
      limit = limit > 0 ? std::min(limit, wanted) : wanted;
    }
  }
  return joint;
}

void JointLimits::mustName(const std::vector<JointDescription>& joints) const {
  std::vector<std::string> known{std::string(kAll)};
  for (const JointDescription& joint : joints) known.push_back(joint.name);
  for (const auto& [name, entry] : joints_) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      entry.fail("is the limit of a joint that is not in the joint map" + didYouMean(name, known));
  }
}

}  // namespace robotui::rt::config
